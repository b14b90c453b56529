#pragma once
// The settings of all methods as one table, and how a program changes them: --settings FILE, then --set. A
// new group of settings (core/setting.h) is one line in settings.cpp.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/settings_table.h"

namespace facenav::app {

/// What a user asks for. Later entries win.
struct SettingsRequest {
  std::optional<std::filesystem::path> file;  // JSON, {"module.name": value}
  std::vector<std::string> assignments;       // "module.name=value"
};

/// With the defaults.
SettingsTable allSettings();
/// What was asked for over the defaults. Throws Error as SettingsTable does.
SettingsTable settingsFor(const SettingsRequest& request);
/// Puts them in force for the rest of the process: once, before any work. Throws Error.
void useSettings(const SettingsRequest& request);

}  // namespace facenav::app
