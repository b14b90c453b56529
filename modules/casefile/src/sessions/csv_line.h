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

}  // namespace facenav::casefile
