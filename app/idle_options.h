#pragma once
// Options that would do nothing: they serve another one that was not given. A person who typed one expects an
// effect, so it is wrong usage.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace facenav::app {

/// Throws WrongUsage if one of `options` was given and none of `served`. Call it in the verb's callback.
void refuseIdle(const CLI::App& verb, const std::vector<std::string>& options,
                const std::vector<std::string>& served);

}  // namespace facenav::app
