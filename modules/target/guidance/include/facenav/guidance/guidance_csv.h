#pragma once
// Writes guidance.csv (columns of resources/doc/formats.md): one line per frame; value columns are empty when
// lost.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "facenav/guidance/coil_gap.h"
#include "facenav/guidance/guidance.h"

namespace facenav::guidance {

struct GuidanceRow {
  std::int64_t frame = 0;
  double t_s = 0.0;
  std::string target;
  GuidanceState state;
  CoilGap gap = {};
};

std::string guidanceCsvHeader();
/// Formats one line with its newline. The target's name is quoted if it contains a comma, quote or line
/// break.
std::string toCsvLine(const GuidanceRow& row);
/// Writes the file completely or not at all. Throws Error.
void writeGuidanceCsv(const std::vector<GuidanceRow>& rows, const std::filesystem::path& path);

}  // namespace facenav::guidance
