#pragma once
// --settings FILE and --set module.name=value, of the command line tool and the window.

#include <CLI/CLI.hpp>

#include "settings.h"

namespace facenav::app {

inline void addSettingsFlags(CLI::App& program, app::SettingsRequest& request) {
  program.add_option("--settings", request.file,
                     "JSON file of settings that are to differ, {\"module.name\": value}");
  program
      .add_option("--set", request.assignments,
                  "module.name=value: one setting that is to differ ('facenav settings' lists them)")
      ->allow_extra_args(false);
}

}  // namespace facenav::app
