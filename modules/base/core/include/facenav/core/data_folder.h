#pragma once
// Where the running program and its data files lie: the learned brain prior, the virtual patient's portrait.
// An installed program and one in the build tree have the same layout, bin/ beside share/facenav/.

#include <filesystem>

namespace facenav {
inline namespace core {

/// Full path of the running program; its bare name where the system does not tell it.
std::filesystem::path programPath();
/// Folder of the data files: FACENAV_DATA if it is set, else share/facenav beside the program's folder, else
/// /usr/share/facenav. It may be missing.
std::filesystem::path dataFolder();

}  // namespace core
}  // namespace facenav
