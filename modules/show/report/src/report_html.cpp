#include "report_html.h"

#include <algorithm>

namespace facenav::report {
namespace {

constexpr const char* kStyle =
    "@page{size:A4;margin:14mm}"
    "body{font:14px/1.45 sans-serif;max-width:1080px;margin:1.5em auto;padding:0 1em;color:#1d2430;"
    "background:#fff}"
    "h1{margin:0}p.subtitle{color:#445;margin:.2em 0 1em}"
    "h2{border-bottom:2px solid #0072b2;padding-bottom:.15em;margin:1.4em 0 .4em;break-after:avoid}"
    "table{border-collapse:collapse;margin:.4em 0}"
    "th,td{padding:.2em .8em .2em 0;border-bottom:1px solid #ccd;text-align:left;vertical-align:top}"
    "th{background:#eef3f8}table.facts td:first-child{color:#445;min-width:17em}"
    "table.pictures td{border:0;width:50%}"
    "tr,svg,img{break-inside:avoid}svg,img{margin:.4em .6em .4em 0}img{max-width:100%}"
    "@media print{body{font-size:11px;margin:0;padding:0}}";

/// Encodes bytes in base64 (RFC 4648).
std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const unsigned group = unsigned(bytes[i]) << 16 | (left > 1 ? unsigned(bytes[i + 1]) << 8 : 0u) |
                           (left > 2 ? unsigned(bytes[i + 2]) : 0u);
    for (std::size_t d = 0; d < 4; ++d) text += d <= left ? kDigits[(group >> (18 - 6 * d)) & 63u] : '=';
  }
  return text;
}

std::string cellHtml(const Cell& cell) {
  return (cell.is_kept ? "<td " + std::string(kKeptMark) + ">" : "<td>") + escapedHtml(cell.words) + "</td>";
}

}  // namespace

std::string escapedHtml(const std::string& words) {
  std::string escaped;
  for (const char c : words) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  }
  return escaped;
}

std::string plainWords(const std::string& html) {
  static const std::vector<std::pair<std::string, char>> kLetters{
      {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&amp;", '&'}};
  std::string words;
  for (std::size_t at = 0; at < html.size();) {
    const auto letter = std::find_if(kLetters.begin(), kLetters.end(), [&](const auto& each) {
      return html.compare(at, each.first.size(), each.first) == 0;
    });
    words += letter == kLetters.end() ? html[at] : letter->second;
    at += letter == kLetters.end() ? 1 : letter->first.size();
  }
  return words;
}

Cell keptCell(std::string words) {
  Cell cell(std::move(words));
  cell.is_kept = true;
  return cell;
}

std::string factsHtml(const std::vector<TableRow>& rows) {
  std::string html = "<table class=\"facts\">\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (const auto& cell : row) html += cellHtml(cell);
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string tableHtml(const TableRow& columns, const std::vector<TableRow>& rows) {
  std::string html = "<table>\n<tr>";
  for (const auto& column : columns) html += "<th>" + escapedHtml(column.words) + "</th>";
  html += "</tr>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (const auto& cell : row) html += cellHtml(cell);
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string headingHtml(const std::string& words) { return "<h2>" + escapedHtml(words) + "</h2>\n"; }
std::string paragraphHtml(const std::string& words) { return "<p>" + escapedHtml(words) + "</p>\n"; }

std::string pictureHtml(const std::vector<std::uint8_t>& png) {
  return "<img alt=\"\" src=\"data:image/png;base64," + base64(png) + "\">\n";
}

std::string pageHtml(const std::string& language, const std::string& title, const std::string& subtitle,
                     const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"" + language + "\"><head><meta charset=\"utf-8\"><title>" +
         escapedHtml(title) + "</title><style>" + kStyle + "</style></head><body>\n<h1>" +
         escapedHtml(title) + "</h1><p class=\"subtitle\">" + escapedHtml(subtitle) + "</p>\n" + body +
         "</body></html>\n";
}

}  // namespace facenav::report
