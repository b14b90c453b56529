#pragma once
// A whole folder that images arrive in under names of our own; commit() numbers them.

#include <filesystem>

#include "facenav/core/whole_folder.h"

namespace facenav::pacs {

constexpr int kMostImages = 20000;  // of one series; more is no series of a head

class IncomingFolder {
 public:
  /// Throws Error when `folder` holds something already or its parent does not exist. Private to the user.
  explicit IncomingFolder(const std::filesystem::path& folder);

  const std::filesystem::path& path() const { return folder_.temporaryPath(); }
  /// Files become 000001.dcm .. (0600), the folder takes its name. Returns their number.
  int commit();

 private:
  WholeFolder folder_;
};

}  // namespace facenav::pacs
