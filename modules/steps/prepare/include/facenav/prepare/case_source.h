#pragma once
// PREPARE: finds the DICOM series that a case was made of, for objects that go back to the archive. A case
// holds no patient: name, study and frame of reference are in the files of the source alone.

#include <filesystem>
#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/dicom/series.h"

namespace facenav::steps {

/// Key of case.json's input_sha256 that holds the hash of the Series Instance UID. The UID itself is not
/// kept: it leads to the patient.
constexpr const char* kSeriesUidHash = "series_uid";

/// The case's series, and its volume: the voxels of the case's MRI at their places, on the series' own grid.
struct CaseSource {
  dicom::SeriesInfo series;
  volume::Volume volume;
};

/// Finds the series below `folder` (or of one file) whose UID has the hash that the case holds, and whose
/// voxels and place are the case's MRI. In a case without that hash the voxels alone decide. Throws Error:
/// the case has no MRI; no series is the case's.
CaseSource sourceOf(const casefile::CaseStore& store, const std::filesystem::path& folder,
                    TaskMonitor& monitor);

}  // namespace facenav::steps
