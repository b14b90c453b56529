#pragma once
// Folder of a verb's results, which appears whole or not at all: it is made beside its final place and
// renamed by finish(), or else removed. An earlier result of the same verb is replaced; anything else is
// kept.

#include <filesystem>
#include <string>

#include "facenav/core/whole_folder.h"

namespace facenav::app {

class ResultFolder {
 public:
  /// `mark`: a file that every result has. `what` names the result ("a demo"). Throws Error if `final`
  /// contains something else.
  ResultFolder(const std::filesystem::path& final, const std::string& mark, const std::string& what);

  /// Folder to write to until finish().
  const std::filesystem::path& path() const { return folder_.temporaryPath(); }
  void finish() { folder_.commit(); }

 private:
  WholeFolder folder_;
};

}  // namespace facenav::app
