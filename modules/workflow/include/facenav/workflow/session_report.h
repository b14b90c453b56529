#pragma once
// The report of a session for the chart: one HTML page without script or other files, to read and to print.
// Its fields are those of the TMSMultiLab session sheet v4.1 with navigation added; what no file of the
// session holds reads "not recorded". It names the case by its id.

#include <filesystem>
#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"

namespace facenav::workflow {

struct ReportOptions {
  bool has_name = false;  // adds the case's label, which may be the patient's name
};

/// The page's text. Throws Error where the case cannot be read.
std::string sessionReport(const casefile::CaseStore& store, const casefile::KeptSession& session,
                          const ReportOptions& options = {});

/// Writes report.html (0600, whole) into the session's folder. Throws Error.
void writeSessionReport(const std::filesystem::path& case_folder,
                        const std::filesystem::path& session_folder);

}  // namespace facenav::workflow
