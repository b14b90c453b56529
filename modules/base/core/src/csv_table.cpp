#include "facenav/core/csv_table.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"

namespace facenav {
inline namespace core {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t'; }

/// Trims blanks at the end, but not before `from` (the end of the quoted part).
void trimEnd(std::string& field, std::size_t from) {
  while (field.size() > from && isBlank(field.back())) field.pop_back();
}

/// Fields of one line. A field may be in double quotes, in which "" means one quote.
std::vector<std::string> split(const std::string& line, bool allows_blanks) {
  std::vector<std::string> fields(1);
  std::size_t quoted = 0;  // characters of the field that were in quotes
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += '"';
      ++i;
    } else if (c == '"') {
      is_quoted = !is_quoted;
      quoted = fields.back().size();
    } else if (c == ',' && !is_quoted) {
      if (allows_blanks) trimEnd(fields.back(), quoted);
      fields.emplace_back();
      quoted = 0;
    } else if (allows_blanks && !is_quoted && isBlank(c) && fields.back().empty()) {
      continue;
    } else {
      fields.back() += c;
    }
  }
  if (allows_blanks) trimEnd(fields.back(), quoted);
  return fields;
}

}  // namespace

std::string csvField(std::string text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c == '\r' || c == '\n' ? ' ' : c;
  }
  return field + '"';
}

CsvTable::CsvTable(const std::filesystem::path& path, const CsvRules& rules) : path_(path) {
  std::string content = readWholeFile(path);
  if (content.rfind("\xEF\xBB\xBF", 0) == 0) content.erase(0, 3);
  std::istringstream stream(content);
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const bool is_empty = rules.allows_blanks ? std::all_of(line.begin(), line.end(), isBlank) : line.empty();
    if (is_empty) continue;
    if (header_.empty()) {
      header_ = split(line, rules.allows_blanks);
      continue;
    }
    lines_.push_back({number, split(line, rules.allows_blanks)});
    if (!rules.allows_ragged_rows && lines_.back().fields.size() != header_.size())
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
  if (!found)
    throw Error("column '" + name + "' is missing in the header line", path_.string() + ", line 1",
                "see resources/doc/formats.md");
  return *found;
}

const std::string& CsvTable::text(std::size_t row, std::size_t column) const {
  const auto& fields = lines_[row].fields;
  if (column >= fields.size()) refuse(row, "the value of column '" + header_[column] + "' is missing");
  return fields[column];
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& field = text(row, column);
  const auto value = numberIn(field);
  if (!value) refuse(row, "'" + field.substr(0, 40) + "' in column '" + header_[column] + "' is no number");
  return *value;
}

std::int64_t CsvTable::integer(std::size_t row, std::size_t column) const {
  const std::string& field = text(row, column);
  std::int64_t value = 0;
  const auto [end, fault] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (fault != std::errc() || end != field.data() + field.size())
    refuse(row, "'" + field.substr(0, 40) + "' in column '" + header_[column] + "' is no whole number");
  return value;
}

void CsvTable::refuse(std::size_t row, const std::string& what, const std::string& remedy) const {
  throw Error(what, path_.string() + ", line " + std::to_string(lines_[row].number), remedy);
}

}  // namespace core
}  // namespace facenav
