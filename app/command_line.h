#pragma once
// The command line of one program: its verbs by step, its help, and its exit status. facenav and facenav-lab
// differ only in their verbs.

#include <string>
#include <vector>

#include "commands/commands.h"

namespace facenav::app {

/// The verbs of one step of the clinic's path. --help lists them together.
struct VerbGroup {
  const char* step;
  std::vector<void (*)(CLI::App&, Context&)> verbs;
};

struct Program {
  std::vector<VerbGroup> groups;
  std::vector<std::string> verbs_with_settings;                // verbs with --settings and --set
  void (*add_peers)(steps::Registrations& methods) = nullptr;  // more implementations; null: none
};

/// Parses, runs one verb, and reports an exception in one line. Returns the exit status: 0 done, 1 failed, 2
/// wrong usage.
int runProgram(const Program& program, int argc, char** argv);

}  // namespace facenav::app
