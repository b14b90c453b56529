#pragma once
// Builds the parts of a report's page. All words are escaped.

#include <cstdint>
#include <string>
#include <vector>

namespace facenav::report {

std::string escapedHtml(const std::string& words);

using TableRow = std::vector<std::string>;
/// Table of names and values, one pair a row.
std::string factsHtml(const std::vector<TableRow>& rows);
std::string tableHtml(const TableRow& columns, const std::vector<TableRow>& rows);
std::string headingHtml(const std::string& words);
std::string paragraphHtml(const std::string& words);
/// Picture whose bytes are in the page.
std::string pictureHtml(const std::vector<std::uint8_t>& png);
/// Whole page, with its style for screen and A4 print.
std::string pageHtml(const std::string& title, const std::string& subtitle, const std::string& body);

}  // namespace facenav::report
