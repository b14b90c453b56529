#pragma once
// Access of the clinic's verbs to facenav-lab, the laboratory's program. It lies beside them, or it is not
// installed.

#include <CLI/CLI.hpp>

#include "context.h"

namespace facenav::app {

/// Adds the laboratory's verbs to the list of --help.
void addLabVerbs(CLI::App& app, Context& context);
/// Prints `facenav help VERB --all` of each of its verbs; nothing if it is not installed.
void printHelpOfLab();

}  // namespace facenav::app
