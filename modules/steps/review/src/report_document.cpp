#include "facenav/review/report_document.h"

#include "facenav/dicom/derived_objects.h"
#include "facenav/prepare/case_source.h"

namespace facenav::steps {

void writeReportDocument(const casefile::CaseStore& store, const std::filesystem::path& session_folder,
                         const std::string& pdf, const std::filesystem::path& source,
                         const std::filesystem::path& output, TaskMonitor& monitor) {
  const auto found = sourceOf(store, source, monitor);
  dicom::writeEncapsulatedPdf(found.series, pdf, "FaceNav session " + session_folder.filename().string(),
                              output);
}

}  // namespace facenav::steps
