#pragma once
// Builds the parts of a report's page. All words are escaped.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace facenav::report {

std::string escapedHtml(const std::string& words);

/// The words of escaped text.
std::string plainWords(const std::string& html);

/// One cell of a table.
struct Cell {
  Cell(const char* text) : words(text) {}
  Cell(std::string text) : words(std::move(text)) {}
  std::string words;
  bool is_kept = false;  // what a person wrote: the same in each language
};
Cell keptCell(std::string words);
constexpr const char* kKeptMark = "translate=\"no\"";  // of such a cell, an attribute of HTML

using TableRow = std::vector<Cell>;
/// Table of names and values, one pair a row.
std::string factsHtml(const std::vector<TableRow>& rows);
std::string tableHtml(const TableRow& columns, const std::vector<TableRow>& rows);
std::string headingHtml(const std::string& words);
std::string paragraphHtml(const std::string& words);
/// Picture whose bytes are in the page.
std::string pictureHtml(const std::vector<std::uint8_t>& png);
/// Whole page, with its style for screen and A4 print. `language`: "en".
std::string pageHtml(const std::string& language, const std::string& title, const std::string& subtitle,
                     const std::string& body);

}  // namespace facenav::report
