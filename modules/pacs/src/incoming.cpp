#include "incoming.h"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace facenav::pacs {
namespace fs = std::filesystem;

IncomingFolder::IncomingFolder(const fs::path& folder)
    : folder_(fs::absolute(folder).lexically_normal(), FileAccess::owner_only) {}

int IncomingFolder::commit() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  int count = 0;
  for (const auto& file : files) {
    char name[24];
    std::snprintf(name, sizeof name, "%06d.dcm", ++count);
    fs::rename(file, path() / name);
  }
  folder_.commit();
  return count;
}

}  // namespace facenav::pacs
