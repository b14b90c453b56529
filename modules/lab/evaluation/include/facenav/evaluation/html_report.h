#pragma once
// report.html: tables and figures of a run on one page. Figures are separate files, named relative to the
// page.

#include <string>
#include <vector>

namespace facenav::evaluation {

struct ReportTable {
  std::string heading;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

struct ReportFigure {
  std::string caption;
  std::string file;  // path relative to the report; .png, .svg, or a video (.webm, .mp4, .avi)
};

struct ReportSection {
  std::string heading, text;
  std::vector<ReportTable> tables;
  std::vector<ReportFigure> figures;
};

/// Makes the page. All text is escaped; no script, no external resource.
std::string htmlReport(const std::string& title, const std::string& subtitle,
                       const std::vector<ReportSection>& sections);

}  // namespace facenav::evaluation
