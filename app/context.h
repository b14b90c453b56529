#pragma once
// What every command can use: the registered implementations, progress on the terminal, the folder for cached
// data.

#include <filesystem>

#include "facenav/core/task_monitor.h"
#include "registrations.h"
#include "settings.h"

namespace facenav::app {

struct Context {
  steps::Registrations registrations;
  TaskMonitor& monitor;           // progress on a terminal; cancelled by Ctrl-C
  std::filesystem::path program;  // full path of the running facenav
  bool is_quiet = false;
  app::SettingsRequest settings = {};  // from the flags of the running verb

  /// FACENAV_CACHE, else the build folder's cache beside the program, else facenav in the user's cache
  /// folder.
  std::filesystem::path cacheFolder() const;
};

}  // namespace facenav::app
