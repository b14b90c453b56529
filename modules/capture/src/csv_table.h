#pragma once
// A CSV file with a header line (FORMATS.md): columns found by name, unknown ones ignored, errors naming file
// and line.

#include <filesystem>
#include <string>
#include <vector>

namespace facenav::capture {

struct NumericTable {
  std::vector<std::vector<double>> rows;  // the wanted columns, in the order asked for
  std::vector<int> lines;                 // line of each row in the file, from 1
};

/// Reads the wanted columns as numbers. Throws Error: no header, a column missing, a value that is no finite
/// number.
NumericTable readColumns(const std::filesystem::path& path, const std::vector<std::string>& columns);

/// "file, line 7": where an error lies.
std::string atLine(const std::filesystem::path& path, int line);

}  // namespace facenav::capture
