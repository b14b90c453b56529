#pragma once
// The private folder of a file group: `.tmp<process>_<number>_<boot>_group`, with new/ and old/ inside. The
// group's program holds a lock on it while it lives, and the kernel releases the lock when the program ends,
// however it ends. Private to casefile.

#include <filesystem>
#include <optional>
#include <string>

namespace facenav::casefile {

/// Makes a name that no other group of this machine has.
std::string newGroupName();

/// Program that made a group folder, as encoded in the folder's name.
struct GroupMaker {
  long process = 0;
  std::string boot;  // the machine's boot id, 8 hex digits, new at each start; empty: not given
};
/// Parses a folder's name; nothing if it is not the name of a group folder.
std::optional<GroupMaker> makerOf(const std::string& folder_name);

/// Lock on a group folder, if the file system supports locks.
class GroupLock {
 public:
  /// Tries to take the lock without waiting.
  explicit GroupLock(const std::filesystem::path& group_folder);
  ~GroupLock();
  GroupLock(const GroupLock&) = delete;
  GroupLock& operator=(const GroupLock&) = delete;
  /// True if this group has the lock; false also if the file system has no locks.
  bool isHeld() const { return is_held_; }

 private:
  int descriptor_ = -1;
  bool is_held_ = false;
};

}  // namespace facenav::casefile
