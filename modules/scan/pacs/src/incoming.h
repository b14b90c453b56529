#pragma once
// The folder into which received images are written under our own names; commit() numbers them.

#include <filesystem>

#include "facenav/core/whole_folder.h"

namespace facenav::pacs {

constexpr int kMostImages = 20000;  // limit for one series; no head series has more

class IncomingFolder {
 public:
  /// Accessible to the user only. Throws Error if `folder` is not empty or its parent does not exist.
  explicit IncomingFolder(const std::filesystem::path& folder);

  const std::filesystem::path& path() const { return folder_.temporaryPath(); }
  /// Removes what an attempt left, before the next one.
  void clear() const;
  /// Renames the files to 000001.dcm .. (0600) and moves the folder to its final name. Returns the number of
  /// files.
  int commit();

 private:
  WholeFolder folder_;
};

}  // namespace facenav::pacs
