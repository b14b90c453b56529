#pragma once
// Errors of a run frame by frame: the head's motion since the alignment, the head as shown (alignment
// included), the coil, and the coil against the head; which frames showed a wrong pose as tracked.

#include <optional>
#include <vector>

#include "facenav/evaluation/run_record.h"

namespace facenav::evaluation {

struct ErrorAt {
  double mm = 0.0, deg = 0.0;
};

struct FrameErrors {
  std::optional<ErrorAt> motion;           // at the cortical target, with the true alignment put in
  std::optional<ErrorAt> head;             // at the cortical target, alignment's error included
  std::optional<ErrorAt> coil;             // the marker's centre
  std::optional<ErrorAt> relative;         // the target as the tracked coil has it, in the tracked head
  std::optional<ErrorAt> relative_motion;  // the same with the true alignment put in
  bool is_head_wrong = false, is_coil_wrong = false;  // tracked, and off by more than 3 mm or 2 degrees
  double coil_distance_mm = 0.0,
         coil_tilt_deg = 0.0;  // true place of the marker: from the cameras, off frontal
};

/// Beyond these a pose is wrong, and showing it as tracked is the one thing that must not happen.
constexpr double kWrong_mm = 3.0, kWrong_deg = 2.0;

/// One per frame of the run.
std::vector<FrameErrors> frameErrors(const RunRecord& run);

/// Time (s) of the longest row of frames in which the head was lost though it could be seen.
double longestLoss_s(const RunRecord& run);
/// After each stretch in which the head could not be known: time (s) until it was tracked again, counted from
/// the first frame that shows at least half as much of the face as the median frame does. The run's whole
/// rest where it never was.
std::vector<double> timesToFindAgain_s(const RunRecord& run);
/// rms distance (mm) of the target from its mean, over the tracked frames: what a still head seems to move.
double jitter_mm(const RunRecord& run);

}  // namespace facenav::evaluation
