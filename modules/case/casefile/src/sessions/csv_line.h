#pragma once
// Single fields of a CSV line, for files that a running session appends to: a torn or damaged line is
// skipped, not refused (CsvTable is the strict reader).

#include <optional>
#include <string>
#include <vector>

namespace facenav::casefile {

/// Returns the field at `column` of a line; a quoted field may contain commas.
std::optional<std::string> fieldAt(const std::string& line, std::size_t column);
/// Returns all fields, without quotes.
std::vector<std::string> fieldsOf(const std::string& line);
std::optional<std::size_t> columnOf(const std::string& header, const std::string& name);
std::optional<double> numberAt(const std::string& line, std::size_t column);

/// Moves the fields of lines written under one header to the columns of another one, by name. Needed when a
/// session continues the file of an older version, which has fewer columns. Columns unknown to the other
/// header are left out; columns that the lines lack stay empty.
class ColumnOrder {
 public:
  ColumnOrder(const std::string& written_header, const std::string& wanted_header);
  /// Returns the line in the other order. Both lines end with a newline.
  std::string inOrder(const std::string& line) const;

 private:
  bool is_same_;
  std::vector<std::optional<std::size_t>> from_;  // source column of each wanted column
};

}  // namespace facenav::casefile
