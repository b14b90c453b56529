#include "csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {
namespace {

/// Fields of one line; a field may stand in double quotes, in which "" is a quote.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += '"';
      ++i;
    } else if (c == '"') {
      is_quoted = !is_quoted;
    } else if (c == ',' && !is_quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& path) : path_(path) {
  std::string content = readWholeFile(path);
  if (content.rfind("\xEF\xBB\xBF", 0) == 0) content.erase(0, 3);
  std::istringstream stream(content);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    if (header_.empty()) {
      header_ = split(line);
      continue;
    }
    lines_.push_back({number, split(line)});
    if (lines_.back().fields.size() != header_.size())
      refuse(lines_.size() - 1, std::to_string(header_.size()) + " fields were expected, " +
                                    std::to_string(lines_.back().fields.size()) + " found");
  }
  if (header_.empty()) throw Error("is empty, a CSV file with a header line was expected", path.string());
}

std::optional<std::size_t> CsvTable::findColumn(const std::string& name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  if (found == header_.end()) return std::nullopt;
  return std::size_t(found - header_.begin());
}

std::size_t CsvTable::column(const std::string& name) const {
  const auto found = findColumn(name);
  if (!found) throw Error("column '" + name + "' is missing", path_.string() + ", line 1");
  return *found;
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& field = text(row, column);
  double value = 0.0;
  const auto [end, fault] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (fault != std::errc() || end != field.data() + field.size() || !std::isfinite(value))
    refuse(row, "a number was expected in column '" + header_[column] + "'");
  return value;
}

std::int64_t CsvTable::integer(std::size_t row, std::size_t column) const {
  const std::string& field = text(row, column);
  std::int64_t value = 0;
  const auto [end, fault] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (fault != std::errc() || end != field.data() + field.size())
    refuse(row, "a whole number was expected in column '" + header_[column] + "'");
  return value;
}

void CsvTable::refuse(std::size_t row, const std::string& what) const {
  throw Error(what, path_.string() + ", line " + std::to_string(lines_[row].number));
}

std::string fixed(double value, int decimals) {
  char text[400];
  const auto result = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
  return {text, result.ptr};
}

}  // namespace facenav::casefile
