#pragma once
// facenav-lab, the laboratory's program, as the clinic's verbs know it. It lies beside them, or it is not
// installed.

#include <CLI/CLI.hpp>

#include "context.h"

namespace facenav::app {

/// The laboratory's verbs in the list of --help.
void addLabVerbs(CLI::App& app, Context& context);
/// Prints what `facenav help VERB --all` says of each of its verbs; nothing where it is not installed.
void printHelpOfLab();

}  // namespace facenav::app
