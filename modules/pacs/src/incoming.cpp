#include "incoming.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "facenav/core/error.h"

namespace facenav::pacs {
namespace fs = std::filesystem;

IncomingFolder::IncomingFolder(const fs::path& folder) : wanted_(fs::absolute(folder).lexically_normal()) {
  if (!wanted_.has_filename()) wanted_ = wanted_.parent_path();
  std::error_code error;
  if (fs::exists(wanted_, error) && !(fs::is_directory(wanted_, error) && fs::is_empty(wanted_, error)))
    throw Error("exists already and is not empty", wanted_.string(), "choose another folder");
  if (!fs::is_directory(wanted_.parent_path(), error))
    throw Error("no such folder to receive in", wanted_.parent_path().string(), "create it first");
  std::string name = (wanted_.parent_path() / (".incoming_XXXXXX")).string();
  if (!::mkdtemp(name.data()))  // 0700
    throw Error("cannot be written to", wanted_.parent_path().string(), "check space and permissions");
  path_ = name;
}

IncomingFolder::~IncomingFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

int IncomingFolder::commit() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path_)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  int count = 0;
  for (const auto& file : files) {
    char name[24];
    std::snprintf(name, sizeof name, "%06d.dcm", ++count);
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    fs::rename(file, path_ / name);
  }
  std::error_code error;
  fs::rename(path_, wanted_, error);  // an empty folder of that name is replaced
  if (error)
    throw Error("cannot be written (" + error.message() + ")", wanted_.string(), "choose another folder");
  path_.clear();
  return count;
}

}  // namespace facenav::pacs
