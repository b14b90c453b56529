#include "facenav/evaluation/html_report.h"

#include <sstream>

namespace facenav::evaluation {
namespace {

constexpr const char* kStyle =
    "body{font:16px/1.5 sans-serif;max-width:1180px;margin:2em auto;padding:0 "
    "1em;color:#1d2430;background:#fff}"
    "h1{margin-bottom:0}p.subtitle{color:#566;margin-top:.2em}h2{border-bottom:2px solid "
    "#0072b2;padding-bottom:.2em}"
    "table{border-collapse:collapse;margin:1em 0}th,td{padding:.35em .9em;border-bottom:1px solid "
    "#ccd;text-align:left}"
    "th{background:#eef3f8}figure{margin:1em 0;display:inline-block;vertical-align:top;max-width:100%}"
    "figcaption{color:#445;font-size:14px}img,video{max-width:100%;border-radius:4px}";

std::string escaped(const std::string& text) {
  std::string out;
  for (char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

void writeTable(std::ostream& html, const ReportTable& table) {
  if (!table.heading.empty()) html << "<h3>" << escaped(table.heading) << "</h3>";
  html << "<table><tr>";
  for (const auto& column : table.columns) html << "<th>" << escaped(column) << "</th>";
  html << "</tr>\n";
  for (const auto& row : table.rows) {
    html << "<tr>";
    for (const auto& cell : row) html << "<td>" << escaped(cell) << "</td>";
    html << "</tr>\n";
  }
  html << "</table>\n";
}

void writeFigure(std::ostream& html, const ReportFigure& figure) {
  const bool is_video = endsWith(figure.file, ".webm") || endsWith(figure.file, ".mp4");
  const bool is_image = endsWith(figure.file, ".png") || endsWith(figure.file, ".svg");
  html << "<figure>";
  if (is_video)
    html << "<video controls loop muted src=\"" << escaped(figure.file) << "\"></video>";
  else if (is_image)
    html << "<img src=\"" << escaped(figure.file) << "\" alt=\"" << escaped(figure.caption) << "\">";
  else
    html << "<a href=\"" << escaped(figure.file) << "\">" << escaped(figure.file) << "</a>";
  html << "<figcaption>" << escaped(figure.caption) << "</figcaption></figure>\n";
}

}  // namespace

std::string htmlReport(const std::string& title, const std::string& subtitle,
                       const std::vector<ReportSection>& sections) {
  std::ostringstream html;
  html << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" << escaped(title)
       << "</title><style>" << kStyle << "</style></head><body>\n<h1>" << escaped(title)
       << "</h1><p class=\"subtitle\">" << escaped(subtitle) << "</p>\n";
  for (const auto& section : sections) {
    html << "<h2>" << escaped(section.heading) << "</h2>\n";
    if (!section.text.empty()) html << "<p>" << escaped(section.text) << "</p>\n";
    for (const auto& table : section.tables) writeTable(html, table);
    for (const auto& figure : section.figures) writeFigure(html, figure);
  }
  html << "</body></html>\n";
  return html.str();
}

}  // namespace facenav::evaluation
