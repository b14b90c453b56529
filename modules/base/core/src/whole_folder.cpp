#include "facenav/core/whole_folder.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>

#include <cerrno>

#include "durable.h"
#include "facenav/core/error.h"
#include "facenav/core/standard_output.h"

namespace facenav {
inline namespace core {
namespace fs = std::filesystem;
namespace {

/// Path without its last slash: "out/" has an empty file name.
fs::path withoutLastSlash(const fs::path& folder) {
  return folder.has_filename() || !folder.has_parent_path() ? folder : folder.parent_path();
}

bool isTaken(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder, error) && !(fs::is_directory(folder, error) && fs::is_empty(folder, error));
}

void makePrivate(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (!entry.is_symlink()) setMode(entry.path(), entry.is_directory() ? 0700 : 0600);
}

/// Moves the old folder aside first, for file systems that cannot swap two folders.
void replaceInTwoSteps(const fs::path& fresh, const fs::path& folder) {
  const fs::path aside = fresh.string() + "_old";
  if (::rename(folder.c_str(), aside.c_str()) != 0) refuseWriting(folder);
  if (::rename(fresh.c_str(), folder.c_str()) != 0) {
    const int reason = errno;
    ::rename(aside.c_str(), folder.c_str());
    errno = reason;
    refuseWriting(folder);
  }
  std::error_code ignored;
  fs::remove_all(aside, ignored);
}

void replace(const fs::path& fresh, const fs::path& folder) {
  if (!isTaken(folder)) {  // an empty folder of that name is replaced too
    if (::rename(fresh.c_str(), folder.c_str()) != 0) refuseWriting(folder);
  } else if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) {
    std::error_code ignored;
    fs::remove_all(fresh, ignored);  // now contains the old content
  } else {
    replaceInTwoSteps(fresh, folder);
  }
}

/// The folder that is filled, behind links.
fs::path placeOfFolder(const fs::path& folder) {
  if (isStandardOutput(folder))
    throw Error("a folder cannot be written to standard output", {}, "give the folder a name");
  const fs::path place = placeOf(folder);
  if (fs::exists(place) && !fs::is_directory(place))
    throw Error("is a file, a folder is written here", folder.string(), "choose another place");
  return place;
}

}  // namespace

WholeFolder::WholeFolder(const fs::path& folder, FileAccess access, Existing existing)
    : folder_(placeOfFolder(withoutLastSlash(folder))), access_(access), existing_(existing) {
  if (existing_ == Existing::refuse && isTaken(folder_))
    throw Error("exists already and is not empty", folder_.string(), "choose another folder or remove it");
  temporary_ = temporaryBeside(folder_);
  if (::mkdir(temporary_.c_str(), access_ == FileAccess::owner_only ? 0700 : 0777) != 0)
    refuseWriting(folder_);
}

WholeFolder::~WholeFolder() {
  std::error_code ignored;
  if (!is_committed_) fs::remove_all(temporary_, ignored);
}

void WholeFolder::commit() {
  FACENAV_EXPECT(!is_committed_, "the folder is in its place already");
  if (access_ == FileAccess::owner_only) makePrivate(temporary_);
  syncAllIn(temporary_);
  if (existing_ == Existing::refuse && isTaken(folder_))
    throw Error("was filled by someone else meanwhile", folder_.string(), "choose another folder");
  replace(temporary_, folder_);
  is_committed_ = true;
  syncNamesIn(parentOf(folder_));
}

void makePrivateFolder(const fs::path& folder) {
  if (::mkdir(folder.c_str(), 0700) != 0) refuseWriting(folder);
}

void makePrivateAndDurable(const fs::path& folder) {
  makePrivate(folder);
  setMode(folder, 0700);
  syncAllIn(folder);
}

void makeNamesDurable(const fs::path& folder) { syncNamesIn(folder); }

}  // namespace core
}  // namespace facenav
