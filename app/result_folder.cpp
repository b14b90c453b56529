#include "result_folder.h"

#include <unistd.h>

#include "facenav/core/error.h"

namespace facenav::app {
namespace fs = std::filesystem;

ResultFolder::ResultFolder(const fs::path& final, const std::string& mark, const std::string& what)
    : final_(fs::absolute(final).lexically_normal()) {
  if (!final_.has_filename()) final_ = final_.parent_path();
  if (fs::exists(final_) && !fs::is_empty(final_) && !fs::exists(final_ / mark))
    throw Error("exists and is no result of " + what, final_.string(), "choose another folder with -o");
  fs::create_directories(final_.parent_path());
  temporary_ =
      final_.parent_path() / ("." + final_.filename().string() + ".tmp" + std::to_string(::getpid()));
  fs::create_directory(temporary_);
}

ResultFolder::~ResultFolder() {
  std::error_code ignored;
  if (!is_done_) fs::remove_all(temporary_, ignored);
}

void ResultFolder::finish() {
  fs::remove_all(final_);
  fs::rename(temporary_, final_);
  is_done_ = true;
}

}  // namespace facenav::app
