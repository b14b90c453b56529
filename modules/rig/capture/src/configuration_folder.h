#pragma once
// The user's configuration folder of this program: rigs and the passwords of cameras.

#include <filesystem>

namespace facenav::capture {

/// $XDG_CONFIG_HOME/facenav, else ~/.config/facenav. Throws Error with `remedy` if the user has no home
/// folder.
std::filesystem::path configurationFolder(const std::string& remedy);

}  // namespace facenav::capture
