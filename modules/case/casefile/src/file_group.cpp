#include "facenav/casefile/file_group.h"

#include "facenav/core/error.h"
#include "facenav/core/whole_folder.h"
#include "group_folder.h"

namespace facenav::casefile {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  return names;
}

/// True if the path exists, dangling links included.
bool isThere(const fs::path& path) { return fs::exists(fs::symlink_status(path)); }

}  // namespace

FileGroup::FileGroup(fs::path folder) : folder_(std::move(folder)) {
  removeAbandonedGroups(folder_);
  root_ = folder_ / newGroupName();
  fresh_ = root_ / "new";
  old_ = root_ / "old";
  makePrivateFolder(root_);
  lock_ = std::make_unique<GroupLock>(root_);
  makePrivateFolder(fresh_);
  makePrivateFolder(old_);
}

FileGroup::~FileGroup() {
  std::error_code ignored;
  fs::remove_all(keeps_old_ ? fresh_ : root_, ignored);
}

void FileGroup::move(const fs::path& from, const fs::path& to) {
  std::error_code fault;
  fs::rename(from, to, fault);
  if (fault)
    throw Error("cannot be written (" + fault.message() + ")", to.string(),
                "check free disk space and permissions");
  moves_.push_back({from, to});
}

void FileGroup::setAside(const std::string& name) {
  const fs::path place = folder_ / name;
  if (!isThere(place)) return;
  if (fs::is_directory(place) != fs::is_directory(fresh_ / name))
    throw Error(
        fs::is_directory(place) ? "is a folder, a file was expected" : "is a file, a folder was expected",
        place.string(), "move it elsewhere");
  move(place, old_ / name);
}

void FileGroup::putInPlace(const std::string& name) { move(fresh_ / name, folder_ / name); }

void FileGroup::undo() {
  for (auto last = moves_.rbegin(); last != moves_.rend(); ++last) {
    std::error_code fault;
    fs::rename(last->to, last->from, fault);
    if (fault) keeps_old_ = true;
  }
  moves_.clear();
}

void FileGroup::commit(const std::string& key) {
  FACENAV_EXPECT(fs::exists(fresh_ / key), "the group's key file was not written");
  makePrivateAndDurable(fresh_);
  try {
    setAside(key);
    for (const std::string& name : namesIn(fresh_)) {
      if (name == key) continue;
      setAside(name);
      putInPlace(name);
    }
    putInPlace(key);
  } catch (...) {
    undo();
    throw;
  }
  makeNamesDurable(folder_);
}

}  // namespace facenav::casefile
