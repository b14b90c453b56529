#pragma once
// Completion of the command line for bash and zsh, made from the same description as --help.

#include <CLI/CLI.hpp>
#include <string>

namespace facenav::app {

/// Returns the script that completes verbs, options and the options' fixed values; elsewhere files. Load it
/// with `source <(facenav help --completion bash)`; for zsh it also works as a file _facenav in $fpath.
std::string bashCompletion(const CLI::App& program);
std::string zshCompletion(const CLI::App& program);

}  // namespace facenav::app
