#pragma once
// CsvTable: a CSV file with a header line, read strictly; faults name file and line.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace facenav::casefile {

class CsvTable {
 public:
  /// Throws Error: no file, empty file, or a line whose number of fields differs from the header's.
  explicit CsvTable(const std::filesystem::path& path);

  std::size_t rows() const { return lines_.size(); }
  /// Index of a column. Throws Error when the header lacks it.
  std::size_t column(const std::string& name) const;
  std::optional<std::size_t> findColumn(const std::string& name) const;
  const std::string& text(std::size_t row, std::size_t column) const { return lines_[row].fields[column]; }
  /// A finite number, '.' decimals whatever the locale. Throws Error.
  double number(std::size_t row, std::size_t column) const;
  std::int64_t integer(std::size_t row, std::size_t column) const;
  /// Throws Error("<what>") naming file and line.
  [[noreturn]] void refuse(std::size_t row, const std::string& what) const;

 private:
  struct Line {
    std::size_t number;
    std::vector<std::string> fields;
  };
  std::filesystem::path path_;
  std::vector<std::string> header_;
  std::vector<Line> lines_;
};

/// `value` with `decimals` digits behind a '.', whatever the locale.
std::string fixed(double value, int decimals);

}  // namespace facenav::casefile
