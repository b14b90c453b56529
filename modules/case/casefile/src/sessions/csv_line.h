#pragma once
// Single fields of a CSV line, for files that a running session appends to: a torn or damaged line is
// skipped, not refused (CsvTable is the strict reader).

#include <optional>
#include <string>
#include <vector>

namespace facenav::casefile {

/// The field at `column` of a line; a field may be quoted and then holds commas.
std::optional<std::string> fieldAt(const std::string& line, std::size_t column);
/// All fields; quotes are taken off.
std::vector<std::string> fieldsOf(const std::string& line);
std::optional<std::size_t> columnOf(const std::string& header, const std::string& name);
/// Nothing unless the whole text is a number.
std::optional<double> numberOf(const std::string& text);
std::optional<double> numberAt(const std::string& line, std::size_t column);

/// Puts lines that were written for one header under the columns of another one, by name: a file of an older
/// version that is gone on with has fewer columns. What the other header does not name is left out; what the
/// lines do not have stays empty.
class ColumnOrder {
 public:
  ColumnOrder(const std::string& written_header, const std::string& wanted_header);
  /// Both lines end with a newline.
  std::string inOrder(const std::string& line) const;

 private:
  bool is_same_;
  std::vector<std::optional<std::size_t>> from_;  // of each wanted column, the written one
};

}  // namespace facenav::casefile
