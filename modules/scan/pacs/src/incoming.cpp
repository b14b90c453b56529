#include "incoming.h"

#include <algorithm>
#include <vector>

#include "facenav/core/number_text.h"

namespace facenav::pacs {
namespace fs = std::filesystem;

IncomingFolder::IncomingFolder(const fs::path& folder)
    : folder_(fs::absolute(folder).lexically_normal(), FileAccess::owner_only) {}

void IncomingFolder::clear() const {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path())) files.push_back(entry.path());
  for (const auto& file : files) fs::remove_all(file);
}

int IncomingFolder::commit() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  int count = 0;
  for (const auto& file : files) {
    fs::rename(file, path() / formatted("%06d.dcm", ++count));
  }
  folder_.commit();
  return count;
}

}  // namespace facenav::pacs
