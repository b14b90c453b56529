#pragma once
// A folder that a verb fills: it appears whole or not at all. Made beside its final place, renamed there by
// finish(), removed if that is never reached. An earlier result of the same verb is replaced, anything else
// is left alone.

#include <filesystem>
#include <string>

#include "facenav/core/whole_folder.h"

namespace facenav::app {

class ResultFolder {
 public:
  /// `mark`: a file that an earlier result holds. Throws Error where `final` holds something else; `what`
  /// names the result ("a demo").
  ResultFolder(const std::filesystem::path& final, const std::string& mark, const std::string& what);

  /// Where to write until finish().
  const std::filesystem::path& path() const { return folder_.temporaryPath(); }
  void finish() { folder_.commit(); }

 private:
  WholeFolder folder_;
};

}  // namespace facenav::app
