#pragma once
// CsvTable: strict reader of a CSV file with a header line (RFC 4180, UTF-8 with or without a byte order
// mark). Columns are found by name; errors name file and line.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facenav {
inline namespace core {

/// Rules that are relaxed for files typed by people, but not for files written by the program.
struct CsvRules {
  bool allows_blanks = false;  // ignores blanks around a field, outside quotes
  bool allows_ragged_rows =
      false;  // rows may have more or fewer fields than the header; only requested ones must exist
};

/// Formats `text` as one field: in double quotes if it contains a comma, a quote or a line break. CsvTable
/// reads line by line, so line breaks become blanks.
std::string csvField(std::string text);

class CsvTable {
 public:
  /// Throws Error: no file, empty file, or a line whose number of fields differs from the header's.
  explicit CsvTable(const std::filesystem::path& path, const CsvRules& rules = {});

  std::size_t rows() const { return lines_.size(); }
  /// Index of a column. Throws Error when the header lacks it.
  std::size_t column(const std::string& name) const;
  std::optional<std::size_t> findColumn(const std::string& name) const;
  /// Throws Error if a ragged row ends before `column`.
  const std::string& text(std::size_t row, std::size_t column) const;
  /// A finite number; the decimal point is '.' in every locale. Throws Error.
  double number(std::size_t row, std::size_t column) const;
  std::int64_t integer(std::size_t row, std::size_t column) const;
  /// Throws Error("<what>", "<file>, line <n>", "<remedy>").
  [[noreturn]] void refuse(std::size_t row, const std::string& what, const std::string& remedy = {}) const;

 private:
  struct Line {
    std::size_t number;
    std::vector<std::string> fields;
  };
  std::filesystem::path path_;
  std::vector<std::string> header_;
  std::vector<Line> lines_;
};

}  // namespace core
}  // namespace facenav
