#pragma once
// FileAccess: who may read a file or folder that the program makes.

namespace facenav {
inline namespace core {

/// by_umask: as the user's umask says (usually readable by all). owner_only: 0600 for files, 0700 for
/// folders, from the first byte on; for all that is a patient's.
enum class FileAccess { by_umask, owner_only };

}  // namespace core
}  // namespace facenav
