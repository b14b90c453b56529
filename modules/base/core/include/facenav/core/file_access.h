#pragma once
// FileAccess: who may read a file or folder that the program creates.

namespace facenav {
inline namespace core {

/// by_umask: set by the user's umask (usually readable by all). owner_only: 0600 for files and 0700 for
/// folders, from the first byte on; use it for all patient data.
enum class FileAccess { by_umask, owner_only };

}  // namespace core
}  // namespace facenav
