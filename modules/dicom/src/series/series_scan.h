#pragma once
// The scan behind listSeries: which files, then their headers, then the series they make.

#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/dicom/series.h"
#include "header/slice_header.h"

namespace facenav::dicom {

/// Regular files under `folder`, sorted by path; symbolic links to folders are not followed. Throws Error
/// when it does not exist or is empty.
std::vector<std::filesystem::path> filesUnder(const std::filesystem::path& folder, bool is_recursive);

/// The series that `files` make. Damaged DICOM files make series of their own that say so, and the series
/// they seem to belong to is not loadable. Throws Error when none of them is DICOM.
std::vector<SeriesInfo> scanFiles(const std::vector<std::filesystem::path>& files, const std::string& where,
                                  TaskMonitor& monitor);

/// A DICOMDIR, whatever its name. False for what cannot be read.
bool isDicomDir(const std::filesystem::path& path);

/// Reads the header of one file; throws Error naming it.
std::optional<SliceHeader> readHeaderOf(const std::filesystem::path& path);

}  // namespace facenav::dicom
