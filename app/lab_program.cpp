#include "lab_program.h"

#include <cstdio>

#include "command_line.h"
#include "facenav/core/child_process.h"
#include "facenav/core/data_folder.h"
#include "lab_verbs.h"

namespace facenav::app {

void addLabVerbs(CLI::App& app, Context&) {
  for (const LabVerb& verb : kLabVerbs) app.add_subcommand(verb.name, verb.description);
}

void printHelpOfLab() {
  const auto lab = programPath().parent_path() / "facenav-lab";
  if (!std::filesystem::exists(lab)) return;
  std::fflush(stdout);
  for (const LabVerb& verb : kLabVerbs)
    ChildProcess::start({lab.string(), "help", verb.name, "--all"}).wait();
}

}  // namespace facenav::app
