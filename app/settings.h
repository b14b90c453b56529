#pragma once
// The settings of all methods as one table, and how a program changes them: --settings FILE, then --set. A
// new group of settings (core/setting.h) is one line in settings.cpp.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/settings_table.h"

namespace facenav::app {

/// Changes that a user asks for. Later entries win.
struct SettingsRequest {
  std::optional<std::filesystem::path> file;  // JSON, {"module.name": value}
  std::vector<std::string> assignments;       // "module.name=value"
};

/// Table of all settings with their defaults.
SettingsTable allSettings();
/// Returns the defaults with the request applied. Throws Error as SettingsTable does.
SettingsTable settingsFor(const SettingsRequest& request);
/// Puts the request in force for the rest of the process; call it once, before any work. Throws Error.
void useSettings(const SettingsRequest& request);

}  // namespace facenav::app
