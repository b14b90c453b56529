#pragma once
// Reads NIBS-BIDS from a data set, the folder of a person or one markers.tsv.

#include <string>
#include <vector>

#include "facenav/interop/item.h"
#include "file_set.h"

namespace facenav::interop {

/// Words of NIBSCoordinateSystemDescription that leave no doubt about the handle. FaceNav writes them.
inline constexpr const char* kHandleWords = "y points away from the handle";

/// The data set that a folder belongs to: the one with dataset_description.json, else the folder itself.
std::filesystem::path nibsDataSetOf(const std::filesystem::path& folder);
/// Names of the tables of places in a data set, without those of derivatives.
std::vector<std::string> nibsMarkers(const FileSet& files);
/// Reads the runs of one person. Throws Error: several people or spaces, no unit, damaged tables.
OtherFile readNibsSet(const FileSet& files, const std::vector<std::string>& markers);

}  // namespace facenav::interop
