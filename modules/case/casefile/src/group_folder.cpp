#include "group_folder.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <regex>
#include <vector>

#include "facenav/casefile/file_group.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

using namespace std::chrono_literals;

// Age after which no machine still writes the group: an alignment is written within seconds.
constexpr auto kSurelyOver = 24h;

/// Id of this machine's current boot; empty if the system gives none.
std::string thisBoot() {
  std::string id;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
  return id.substr(0, 8);
}

bool hasProcessEnded(long process) { return ::kill(pid_t(process), 0) != 0 && errno == ESRCH; }

/// True if neither the folder nor new/ or old/ in it has changed for kSurelyOver.
bool isOld(const fs::path& group) {
  const auto now = fs::file_time_type::clock::now();
  for (const fs::path& place : {group, group / "new", group / "old"}) {
    std::error_code fault;
    const auto changed = fs::last_write_time(place, fault);
    if (!fault && now - changed < kSurelyOver) return false;
  }
  return true;
}

bool isAbandoned(const fs::path& group, const GroupMaker& maker) {
  const bool is_from_here = !maker.boot.empty() && maker.boot == thisBoot();
  return (is_from_here && hasProcessEnded(maker.process)) || isOld(group);
}

/// True if old/ contains a file or folder that is missing in the case.
bool holdsAnOnlyCopy(const fs::path& group) {
  std::error_code fault;
  for (const auto& entry : fs::directory_iterator(group / "old", fault))
    if (!fs::exists(fs::symlink_status(group.parent_path() / entry.path().filename()))) return true;
  return false;
}

void removeIfAbandoned(const fs::path& group) {
  const auto maker = makerOf(group.filename().string());
  std::error_code ignored;
  if (!maker || fs::is_symlink(group, ignored) || !fs::is_directory(group, ignored)) return;
  const GroupLock lock(group);
  if (!lock.isHeld() || !isAbandoned(group, *maker)) return;
  fs::remove_all(holdsAnOnlyCopy(group) ? group / "new" : group, ignored);
}

}  // namespace

std::string newGroupName() {
  static std::atomic<int> counter{0};
  const std::string boot = thisBoot();
  return ".tmp" + std::to_string(::getpid()) + "_" + std::to_string(counter++) +
         (boot.empty() ? "" : "_" + boot) + "_group";
}

std::optional<GroupMaker> makerOf(const std::string& folder_name) {
  static const std::regex kName(R"(\.tmp([1-9][0-9]{0,8})_[0-9]{1,9}(?:_([0-9a-f]{8}))?_group)");
  std::smatch parts;
  if (!std::regex_match(folder_name, parts, kName)) return std::nullopt;
  return GroupMaker{std::stol(parts[1]), parts[2]};
}

GroupLock::GroupLock(const fs::path& group_folder)
    : descriptor_(::open(group_folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  is_held_ = descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
}

GroupLock::~GroupLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void removeAbandonedGroups(const fs::path& folder) {
  std::error_code fault;
  std::vector<fs::path> places;  // first: removing changes what an iterator walks over
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end; at.increment(fault))
    places.push_back(at->path());
  for (const fs::path& place : places) removeIfAbandoned(place);
}

}  // namespace facenav::casefile
