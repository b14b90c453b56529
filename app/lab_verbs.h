#pragma once
// The laboratory's verbs by name: facenav-lab runs them.

#include <string>
#include <vector>

namespace facenav::app {

struct LabVerb {
  const char* name;
  const char* description;
};

inline constexpr LabVerb kLabVerbs[] = {
    {"simulate", "the virtual treatment room -> recording with exact truth"},
    {"evaluate", "accuracy of the whole path in the virtual room, or of a recording"},
    {"demo", "the whole path on the virtual patient: model, align, track, guide, report"}};

/// Returns true if these words of a command line (without the program's name) are for the laboratory: "demo
/// -o out", "help evaluate".
inline bool isForLab(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "help" || (!word.empty() && word.front() == '-')) continue;
    for (const LabVerb& verb : kLabVerbs)
      if (word == verb.name) return true;
    return false;
  }
  return false;
}

}  // namespace facenav::app
