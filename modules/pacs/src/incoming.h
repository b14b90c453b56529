#pragma once
// A folder beside the wanted one that images arrive in; it takes the wanted name only when all are there.

#include <filesystem>

namespace facenav::pacs {

constexpr int kMostImages = 20000;  // of one series; more is no series of a head

class IncomingFolder {
 public:
  /// Throws Error when `folder` holds something already or its parent does not exist. Private to the user.
  explicit IncomingFolder(const std::filesystem::path& folder);
  /// Removes what arrived unless commit() was reached.
  ~IncomingFolder();
  IncomingFolder(const IncomingFolder&) = delete;
  IncomingFolder& operator=(const IncomingFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Files become 000001.dcm .. (0600), the folder takes its name. Returns their number.
  int commit();

 private:
  std::filesystem::path wanted_, path_;
};

}  // namespace facenav::pacs
