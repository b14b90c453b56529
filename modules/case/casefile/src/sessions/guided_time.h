#pragma once
// Times of a session from its two tables. They can hold millions of lines, so no table is kept in memory.

#include <cstdint>
#include <filesystem>
#include <optional>

#include "facenav/casefile/kept_session.h"

namespace facenav::casefile {

/// Computes the times by state. Between two frames a state holds for 0.25 s; the rest counts as lost, and a
/// rest of a second or more as not guided. Nothing if the file is missing, lacks the columns or has fewer
/// than two frames. Lines cut short are left out.
std::optional<GuidedTime> readGuidedTime(const std::filesystem::path& guidance_csv);
/// Time from the first to the last frame, s; reads only both ends of the file. Nothing as above.
std::optional<double> readDuration_s(const std::filesystem::path& poses_csv);

struct LastFrame {
  std::int64_t frame = 0;
  double t_s = 0;
};
/// Reads the last whole frame of poses.csv, from the end of the file only. Nothing as above.
std::optional<LastFrame> readLastFrame(const std::filesystem::path& poses_csv);

}  // namespace facenav::casefile
