#pragma once
// PLAN: tells files of other programs and electric fields from scans, among what a user drops on the window.
// A file is known by its content.

#include <filesystem>
#include <vector>

namespace facenav::steps {

struct DroppedFiles {
  std::vector<std::filesystem::path> others;  // files of other programs, by name
  std::vector<std::filesystem::path> fields;  // an electric field: mesh, overlay, NIfTI
  bool may_be_scan = false;                   // DICOM or NIfTI; then `others` is empty
};

/// Looks at a file, or at the files in a folder and the folders in it. A folder without a file of another
/// program may be a scan. Never throws; what cannot be read is none of these.
DroppedFiles filesAt(const std::filesystem::path& path);

}  // namespace facenav::steps
