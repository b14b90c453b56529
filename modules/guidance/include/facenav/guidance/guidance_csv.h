#pragma once
// guidance.csv out (columns of FORMATS.md): one line a frame, value columns empty when lost.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "facenav/guidance/guidance.h"

namespace facenav::guidance {

struct GuidanceRow {
  std::int64_t frame = 0;
  double t_s = 0.0;
  std::string target;
  GuidanceState state;
};

std::string guidanceCsvHeader();
/// One line, newline included. The target's name is quoted where it holds a comma, quote or line break.
std::string toCsvLine(const GuidanceRow& row);
/// A whole file. Throws Error.
void writeGuidanceCsv(const std::vector<GuidanceRow>& rows, const std::filesystem::path& path);

}  // namespace facenav::guidance
