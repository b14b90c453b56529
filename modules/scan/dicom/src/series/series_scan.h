#pragma once
// The scan behind listSeries: files, then their headers, then their series.

#include <vector>

#include "facenav/core/task_monitor.h"
#include "facenav/dicom/series.h"
#include "header/slice_header.h"

namespace facenav::dicom {

/// Regular files under `folder`, sorted by path; symbolic links to folders are not followed. Throws Error
/// when it does not exist or is empty.
std::vector<std::filesystem::path> filesUnder(const std::filesystem::path& folder, bool is_recursive);

/// The series of `files`. Damaged DICOM files give series of their own with that problem, and the series that
/// they seem to belong to is not loadable. Throws Error when no file is DICOM.
std::vector<SeriesInfo> scanFiles(const std::vector<std::filesystem::path>& files, const std::string& where,
                                  TaskMonitor& monitor);

/// True if the file is a DICOMDIR, whatever its name. False if it cannot be read.
bool isDicomDir(const std::filesystem::path& path);

/// Reads the header of one file; throws Error naming it.
std::optional<SliceHeader> readHeaderOf(const std::filesystem::path& path);

}  // namespace facenav::dicom
