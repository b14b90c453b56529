#include "csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::capture {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string> splitLine(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(trimmed(cell));
  return cells;
}

std::vector<std::size_t> findColumns(const std::filesystem::path& path, std::string header,
                                     const std::vector<std::string>& columns) {
  if (header.compare(0, 3, "\xEF\xBB\xBF") == 0) header.erase(0, 3);
  const auto names = splitLine(header);
  std::vector<std::size_t> places;
  for (const auto& column : columns) {
    const auto found = std::find(names.begin(), names.end(), column);
    if (found == names.end())
      throw Error("column '" + column + "' is missing in the header line", atLine(path, 1), "see FORMATS.md");
    places.push_back(std::size_t(found - names.begin()));
  }
  return places;
}

double toNumber(const std::filesystem::path& path, int line, const std::string& column,
                const std::string& cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    throw Error("'" + cell.substr(0, 40) + "' in column '" + column + "' is no number", atLine(path, line));
  return value;
}

}  // namespace

std::string atLine(const std::filesystem::path& path, int line) {
  return path.string() + ", line " + std::to_string(line);
}

NumericTable readColumns(const std::filesystem::path& path, const std::vector<std::string>& columns) {
  std::istringstream stream(readWholeFile(path));
  std::string line;
  if (!std::getline(stream, line)) throw Error("is empty, a header line was expected", path.string());
  const auto places = findColumns(path, line, columns);
  NumericTable table;
  for (int number = 2; std::getline(stream, line); ++number) {
    if (trimmed(line).empty()) continue;
    const auto cells = splitLine(line);
    std::vector<double> row;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (places[i] >= cells.size())
        throw Error("the value of column '" + columns[i] + "' is missing", atLine(path, number));
      row.push_back(toNumber(path, number, columns[i], cells[places[i]]));
    }
    table.rows.push_back(std::move(row));
    table.lines.push_back(number);
  }
  return table;
}

}  // namespace facenav::capture
