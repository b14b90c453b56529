#pragma once
// The report of a session for the chart, to read and to print. Its fields are those of the TMSMultiLab
// session sheet v4.1 with navigation added; fields that the session's files lack read "not recorded". It
// identifies the case by its id. Written as one HTML page without script or other files; ui/report_pdf.h
// prints the same content.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/core/rgb_image.h"
#include "facenav/core/sentence_catalogue.h"
#include "facenav/report/chart.h"

namespace facenav::report {

struct ReportPicture {
  std::string caption;
  RgbImage image;
};

struct ReportOptions {
  bool has_name = false;                     // adds the case's label, which may be the patient's name
  std::vector<ReportPicture> pictures = {};  // from pulse_pictures.h
  std::shared_ptr<const SentenceCatalogue> language = {};  // from report_language.h; null: English
};

struct SessionReport {
  struct Figure {
    std::optional<Chart> chart;  // if absent: a picture
    RgbImage picture;
  };
  std::string language = "en";
  std::string title, subtitle;
  std::string page_words;  // foot of a printed page: "page %1 of %2"
  std::string body;        // HTML; figure N is <img src="figure:N">
  std::vector<Figure> figures;
};

/// Makes the report. Throws Error where the case cannot be read.
SessionReport makeSessionReport(const casefile::CaseStore& store, const casefile::KeptSession& session,
                                const ReportOptions& options = {});
/// Returns the page's text, with all figures in it.
std::string toHtml(const SessionReport& report);
/// Makes the report and returns its page.
std::string sessionReport(const casefile::CaseStore& store, const casefile::KeptSession& session,
                          const ReportOptions& options = {});

/// Writes report.html (0600, whole) into the session's folder. Throws Error.
void writeSessionReport(const std::filesystem::path& case_folder, const std::filesystem::path& session_folder,
                        const ReportOptions& options = {});

}  // namespace facenav::report
