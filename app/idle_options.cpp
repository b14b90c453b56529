#include "idle_options.h"

#include <algorithm>

#include "wrong_usage.h"

namespace facenav::app {

void refuseIdle(const CLI::App& verb, const std::vector<std::string>& options,
                const std::vector<std::string>& served) {
  const auto isGiven = [&](const std::string& name) { return verb.get_option(name)->count() > 0; };
  if (std::any_of(served.begin(), served.end(), isGiven)) return;
  std::string words;
  for (const auto& name : served)
    words += (words.empty() ? "" : &name == &served.back() ? " or " : ", ") + name;
  for (const auto& name : options)
    if (isGiven(name)) throw WrongUsage(name + " does nothing here", "give it with " + words);
}

}  // namespace facenav::app
