#pragma once
// Two coils on the command line: --coil given twice, the second one's target, and which coil gave a pulse.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "commands/coil_option.h"
#include "facenav/treat/treatment.h"

namespace facenav::app {

/// Adds --coil, which may be given twice, and --coils. `help`: which coil is meant.
void addCoilsOption(CLI::App& verb, CoilChoice& choice, const std::string& help);
/// Adds --second-target.
void addSecondTargetOption(CLI::App& verb, std::string& target);
/// File of the second coil; nothing: there is none. Throws Error if there is no such coil, and if the two
/// cannot be told apart.
std::optional<std::filesystem::path> secondCoilFile(const CoilChoice& choice);

/// Reads words "SOURCE=COIL" or "COIL" of --pulse-coil. `sources`: those of --pulses; `others`: further ones,
/// which can name the coil with each pulse. Throws WrongUsage for an unknown coil or source, words without a
/// second coil, and for a source whose coil is not said.
steps::CoilOfSource coilOfSourceFrom(const std::vector<std::string>& words,
                                     const std::vector<std::string>& sources,
                                     const std::vector<std::string>& others, const CoilChoice& choice);

}  // namespace facenav::app
