#include "commands/two_coils.h"

#include <algorithm>

#include "facenav/coil_tracking/coil_card.h"
#include "wrong_usage.h"

namespace facenav::app {
namespace {

/// True for a source whose messages can name the coil.
bool canName(const std::string& source) {
  return source.rfind("udp:", 0) == 0 || source.rfind("tcp:", 0) == 0;
}

}  // namespace

void addCoilsOption(CLI::App& verb, CoilChoice& choice, const std::string& help) {
  verb.add_option_function<std::vector<std::string>>(
          "--coil",
          [&choice](const std::vector<std::string>& words) {
            if (words.size() > 2) throw CLI::ValidationError("--coil", "at most two coils are followed");
            choice.words = words.front();
            choice.second = words.size() > 1 ? words.back() : std::string();
          },
          help + "; given twice: a second coil with a marker of its own")
      ->allow_extra_args(false);
  addCoilLibraryOption(verb, choice.library);
}

void addSecondTargetOption(CLI::App& verb, std::string& target) {
  verb.add_option("--second-target", target, "name of the second coil's target");
}

std::optional<std::filesystem::path> secondCoilFile(const CoilChoice& choice) {
  if (choice.second.empty()) return std::nullopt;
  const auto file = coil_library::coilFileOf(choice.second, coil_library::coilLibrary(choice.library));
  coil_tracking::requireTellable(coil_tracking::readCoil(file), coilOf(choice));
  return file;
}

steps::CoilOfSource coilOfSourceFrom(const std::vector<std::string>& words,
                                     const std::vector<std::string>& sources,
                                     const std::vector<std::string>& others, const CoilChoice& choice) {
  steps::CoilOfSource coils;
  if (choice.second.empty()) {
    if (!words.empty())
      throw WrongUsage("--pulse-coil is for a session with two coils", "give --coil twice, or leave it out");
    return coils;
  }
  const std::string first = coilOf(choice).name, second = coilOf({choice.second, choice.library}).name;
  for (const auto& word : words) {
    std::string source, coil = word;
    for (const auto& known : {sources, others})
      for (const auto& each : known)
        if (word.rfind(each + "=", 0) == 0) source = each, coil = word.substr(each.size() + 1);
    if (coil != first && coil != second)
      throw WrongUsage("--pulse-coil " + word + ": no such coil or source",
                       "give COIL or SOURCE=COIL; the coils are '" + first + "' and '" + second + "'");
    coils[source] = coil;
  }
  for (const auto& source : sources)
    if (!coils.count("") && !coils.count(source) && !canName(source))
      throw WrongUsage("two coils are followed, and it is not said which one gives the pulses of " + source,
                       "give --pulse-coil " + source + "=COIL: '" + first + "' or '" + second + "'");
  return coils;
}

}  // namespace facenav::app
