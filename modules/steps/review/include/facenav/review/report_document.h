#pragma once
// REVIEW: a session's report (PDF) as a DICOM object of the patient and study that the case was made from.

#include <filesystem>
#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"

namespace facenav::steps {

/// Writes `pdf` (the file's bytes) as an Encapsulated PDF object. `source`: folder of the original DICOM
/// files. Throws Error as sourceOf and writeEncapsulatedPdf do.
void writeReportDocument(const casefile::CaseStore& store, const std::filesystem::path& session_folder,
                         const std::string& pdf, const std::filesystem::path& source,
                         const std::filesystem::path& output, TaskMonitor& monitor);

}  // namespace facenav::steps
