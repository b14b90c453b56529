#pragma once
// The private folder of a file group: `.tmp<process>_<number>_<boot>_group`, with new/ and old/ inside. The
// group's program holds a lock on it while it lives, and the kernel releases the lock when the program ends,
// however it ends. Private to casefile.

#include <filesystem>
#include <optional>
#include <string>

namespace facenav::casefile {

/// A name that no other group of this machine has.
std::string newGroupName();

/// What a group folder's name says of the program that made it.
struct GroupMaker {
  long process = 0;
  std::string boot;  // of the machine, 8 hex digits: other at each start; empty: not given
};
/// nullopt: not the name of a group folder.
std::optional<GroupMaker> makerOf(const std::string& folder_name);

/// Holds the lock on a group folder, as far as the file system has locks.
class GroupLock {
 public:
  /// Does not wait.
  explicit GroupLock(const std::filesystem::path& group_folder);
  ~GroupLock();
  GroupLock(const GroupLock&) = delete;
  GroupLock& operator=(const GroupLock&) = delete;
  /// False: another group holds it, or the file system has no locks.
  bool isHeld() const { return is_held_; }

 private:
  int descriptor_ = -1;
  bool is_held_ = false;
};

}  // namespace facenav::casefile
