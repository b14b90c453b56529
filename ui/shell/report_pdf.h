#pragma once
// The report of a session as PDF (A4), from the content of report/session_report.h. Needs a
// QGuiApplication; no window.

#include <filesystem>

#include "facenav/report/session_report.h"

class QTextDocument;

namespace facenav::ui {

/// Fills a document with the report, its figures included, for a page 688 px wide.
void fillReport(QTextDocument& document, const report::SessionReport& report);

/// Writes the whole file or nothing, mode 0600. Throws Error if it cannot be written.
void writeReportPdf(const report::SessionReport& report, const std::filesystem::path& path);

}  // namespace facenav::ui
