#include "evaluate/gate_words.h"

#include <map>
#include <utility>

namespace facenav::app {

std::set<std::string> faultsNamedIn(const std::string& words) {
  // Words of a loss, which are the whole text.
  static const std::map<std::string, const char*> kLosses{
      {"out_of_step", "out_of_step"}, {"swapped", "swapped"},         {"cameras_moved", "moved"},
      {"other_rig", "other_rig"},     {"other_face", "other_person"}, {"frozen", "frozen"}};
  if (const auto loss = kLosses.find(words); loss != kLosses.end()) return {loss->second};
  static const std::pair<const char*, const char*> kMessages[] = {
      {"different moments", "out_of_step"},
      {"are exchanged", "swapped"},
      {"look swapped", "swapped"},
      {"cameras have moved", "moved"},
      {"a camera has turned since", "moved"},
      {"turned sideways since the calibration (by", "moved"},
      {"moved on its mount", "moved"},
      {"does not belong to these cameras", "other_rig"},
      {"the MRI is mirrored", "mirrored"},
      {"the patient's own MRI", "other_person"},
  };
  std::set<std::string> named;
  for (const auto& [part, name] : kMessages)
    if (words.find(part) != std::string::npos) named.insert(name);
  for (const char* undecided :
       {"or was measured too coarsely to tell", "cannot be distinguished from its mirror image"})
    if (words.find(undecided) != std::string::npos) named.erase("other_person");
  // These messages blame something else first; the patient's own MRI is their second advice.
  if (named.size() > 1) named.erase("other_person");
  return named;
}

std::string rightNameOf(room::WorldFault fault) {
  switch (fault) {
    case room::WorldFault::none:
      return {};
    case room::WorldFault::turned:
    case room::WorldFault::shifted:
      return "moved";
    default:
      return room::nameOf(fault);
  }
}

}  // namespace facenav::app
