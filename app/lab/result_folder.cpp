#include "result_folder.h"

#include "facenav/core/error.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

/// Returns `final` and creates its parent. Throws Error if it contains something other than an earlier
/// result.
fs::path checkedPlace(const fs::path& final, const std::string& mark, const std::string& what) {
  fs::path place = fs::absolute(final).lexically_normal();
  if (!place.has_filename()) place = place.parent_path();
  if (fs::exists(place) && !fs::is_empty(place) && !fs::exists(place / mark))
    throw Error("exists and is no result of " + what, place.string(), "choose another folder with -o");
  fs::create_directories(place.parent_path());
  return place;
}

}  // namespace

ResultFolder::ResultFolder(const fs::path& final, const std::string& mark, const std::string& what)
    : folder_(checkedPlace(final, mark, what), FileAccess::by_umask, Existing::replace) {}

}  // namespace facenav::app
