#pragma once
// Folder for the files of one trial of an evaluation, removed at its end.

#include <cstdlib>
#include <filesystem>
#include <string>

#include "facenav/core/error.h"

namespace facenav::app {

class ScratchFolder {
 public:
  /// Throws Error if no temporary folder can be made.
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "facenav_evaluate_XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw Error("no temporary folder can be made", name, "check free disk space");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace facenav::app
