#include "csv_line.h"

#include "facenav/core/csv_table.h"
#include "facenav/core/number_text.h"

namespace facenav::casefile {
namespace {

/// Returns the end of the field that begins at `begin`.
std::size_t endOfField(const std::string& line, std::size_t begin) {
  bool is_quoted = false;
  for (std::size_t i = begin; i < line.size(); ++i) {
    if (line[i] == '"') is_quoted = !is_quoted;
    if (line[i] == ',' && !is_quoted) return i;
  }
  return line.size();
}

std::string unquoted(const std::string& field) {
  if (field.size() < 2 || field.front() != '"' || field.back() != '"') return field;
  std::string text;
  for (std::size_t i = 1; i + 1 < field.size(); ++i) {
    text += field[i];
    if (field[i] == '"') ++i;  // "" encodes one quote
  }
  return text;
}

std::string withoutEnd(std::string line) {
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
  return line;
}

}  // namespace

std::optional<std::string> fieldAt(const std::string& line, std::size_t column) {
  std::size_t begin = 0;
  for (std::size_t at = 0;; ++at) {
    const std::size_t end = endOfField(line, begin);
    if (at == column) return line.substr(begin, end - begin);
    if (end == line.size()) return std::nullopt;
    begin = end + 1;
  }
}

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t end = endOfField(line, begin);
    fields.push_back(unquoted(line.substr(begin, end - begin)));
    if (end == line.size()) return fields;
    begin = end + 1;
  }
}

std::optional<std::size_t> columnOf(const std::string& header, const std::string& name) {
  const auto names = fieldsOf(header);
  for (std::size_t column = 0; column < names.size(); ++column)
    if (names[column] == name) return column;
  return std::nullopt;
}

std::optional<double> numberAt(const std::string& line, std::size_t column) {
  const auto field = fieldAt(line, column);
  return field ? numberIn(*field) : std::nullopt;
}

ColumnOrder::ColumnOrder(const std::string& written_header, const std::string& wanted_header)
    : is_same_(withoutEnd(written_header) == withoutEnd(wanted_header)) {
  for (const auto& name : fieldsOf(withoutEnd(wanted_header)))
    from_.push_back(columnOf(withoutEnd(written_header), name));
}

std::string ColumnOrder::inOrder(const std::string& line) const {
  if (is_same_) return line;
  const auto fields = fieldsOf(withoutEnd(line));
  std::string ordered;
  for (const auto& from : from_)
    ordered += (&from == &from_.front() ? "" : ",") + (from ? csvField(fields.at(*from)) : std::string());
  return ordered + "\n";
}

}  // namespace facenav::casefile
