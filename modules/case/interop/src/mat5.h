#pragma once
// MATLAB's .mat of level 5 (MAT-File Format, MathWorks): cells, structures, text and real numbers, also
// compressed by zlib. Everything else in a file (sparse arrays, objects) is skipped.

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace facenav::interop {

struct MatValue {
  enum class Type { numbers, text, cell, structure, other };
  Type type = Type::other;
  std::vector<std::size_t> size;  // of each dimension
  std::vector<double> numbers;    // column by column
  std::string text;
  std::vector<MatValue> cells;                            // of a cell
  std::vector<std::map<std::string, MatValue>> elements;  // of a structure
  std::vector<std::string> fields;                        // of a structure, in order

  static MatValue of(const std::string& words);
  /// Numbers column by column.
  static MatValue of(std::vector<double> values, std::size_t rows, std::size_t columns);
  static MatValue cellOf(std::vector<MatValue> values);
  static MatValue structureOf(std::vector<std::map<std::string, MatValue>> values,
                              std::vector<std::string> fields);
};

using MatFile = std::vector<std::pair<std::string, MatValue>>;  // variables in order

/// Reads the variables. Throws Error: cut short, damaged, larger than 256 MB when unpacked.
MatFile readMat5(const std::string& content, const std::filesystem::path& path);
/// The bytes of a file, little-endian, not compressed.
std::string mat5Of(const MatFile& variables);

}  // namespace facenav::interop
