#pragma once
// PLAN: writes targets and planned coils for the archive: drawn into a copy of the MRI (a DICOM series), or
// as segments on its images (one object).

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"

namespace facenav::steps {

struct DicomExport {
  std::vector<std::string> targets;      // names; empty: the only one
  std::filesystem::path source, output;  // folder of the original DICOM files; folder or file to write
  bool replaces = false;
};

struct ExportedSeries {
  int images = 0;
  std::vector<std::string> targets;
};

/// Writes the places and coils as segments on the source's images: one file, `output`. Throws Error as
/// exportDicomMr does, and if the file exists and is not to be replaced.
ExportedSeries exportDicomSegments(const casefile::CaseStore& store, const DicomExport& order,
                                   TaskMonitor& monitor);

/// Writes the series. Throws Error as sourceOf, burnPlan and writeDerivedSeries do, and where no target or
/// one of several must be named.
ExportedSeries exportDicomMr(const casefile::CaseStore& store, const DicomExport& order,
                             TaskMonitor& monitor);

}  // namespace facenav::steps
