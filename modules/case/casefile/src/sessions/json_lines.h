#pragma once
// Reads a file of JSON objects, one a line. A damaged line, or one that a crash cut short, is left out and
// named.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/core/json_reader.h"

namespace facenav::casefile {

struct JsonLines {
  std::vector<JsonReader> lines;
  std::vector<std::string> problems;
};

/// Reads the lines; empty if there is no such file. Throws Error if it cannot be read.
JsonLines readJsonLines(const std::filesystem::path& path);

}  // namespace facenav::casefile
