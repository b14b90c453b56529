#pragma once
// FileAccess: who may read a file or folder that the program creates.

namespace facenav {
inline namespace core {

/// owner_only: 0600 for files and 0700 for folders, from the first byte on; every writer's default, since
/// most of what is written is about a patient. by_umask: set by the user's umask (usually readable by all);
/// for what belongs to no patient (calibrations, coils, pages to print) and may be shared.
enum class FileAccess { by_umask, owner_only };

}  // namespace core
}  // namespace facenav
