#pragma once
// Reads a file of JSON objects, one a line. A line that a crash cut short, or that is damaged, is left out
// and named; the rest counts.

#include <filesystem>
#include <string>
#include <vector>

#include "facenav/core/json_reader.h"

namespace facenav::casefile {

struct JsonLines {
  std::vector<JsonReader> lines;
  std::vector<std::string> problems;
};

/// Empty if there is no such file. Throws Error if it cannot be read.
JsonLines readJsonLines(const std::filesystem::path& path);

}  // namespace facenav::casefile
