#pragma once
// A recording that a test program writes once and shares. A long one has thousands of files, which take
// seconds to make.

#include <filesystem>
#include <functional>
#include <string>

#include "support/test_data.h"

namespace facenav::testing {

/// Makes the recording `to`, whose picture folders are links to those of the program's recording `name`.
/// `write` makes that one in the given folder when it is first asked for.
inline void shareRecording(const std::string& name,
                           const std::function<void(const std::filesystem::path&)>& write,
                           const std::filesystem::path& to) {
  namespace fs = std::filesystem;
  static const TemporaryFolder kept;
  const fs::path from = kept.path() / name;
  if (!fs::exists(from)) write(from);
  fs::create_directories(to);
  for (const auto& entry : fs::directory_iterator(from)) {
    const fs::path copy = to / entry.path().filename();
    if (entry.is_directory())
      fs::create_directory_symlink(entry.path(), copy);
    else
      fs::copy_file(entry.path(), copy);
  }
}

}  // namespace facenav::testing
