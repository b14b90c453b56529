#pragma once
// Errors of a run, frame by frame: the head's motion since the alignment, the head as displayed (including
// the alignment's error), the coil, and the coil relative to the head. Also marks the frames with a wrong
// pose shown as tracked.

#include <optional>
#include <vector>

#include "facenav/evaluation/run_record.h"

namespace facenav::evaluation {

struct ErrorAt {
  double mm = 0.0, deg = 0.0;
};

struct FrameErrors {
  std::optional<ErrorAt> motion;           // at the cortical target, with the true alignment
  std::optional<ErrorAt> head;             // at the cortical target, including the alignment's error
  std::optional<ErrorAt> coil;             // the marker's centre
  std::optional<ErrorAt> relative;         // the target carried by the tracked coil, in the tracked head
  std::optional<ErrorAt> relative_motion;  // `relative` with the true alignment
  bool is_head_wrong = false, is_coil_wrong = false;  // tracked, but more than 3 mm or 2 degrees off
  double coil_distance_mm = 0.0,
         coil_tilt_deg = 0.0;  // true marker pose: distance from the cameras, angle to frontal
};

/// Limits above which a pose is wrong. A wrong pose must never be shown as tracked.
constexpr double kWrong_mm = 3.0, kWrong_deg = 2.0;

/// Computes the errors, one entry per frame of the run.
std::vector<FrameErrors> frameErrors(const RunRecord& run);

/// Duration (s) of the longest run of frames in which the head was lost although it was visible.
double longestLoss_s(const RunRecord& run);
/// Recovery time (s) after each stretch in which no head pose was possible. It counts from the first frame
/// that shows at least half as much of the face as the median frame, until the head was tracked again, else
/// to the end of the run.
std::vector<double> timesToFindAgain_s(const RunRecord& run);
/// rms distance (mm) of the target from its mean, over the tracked frames: the apparent motion of a still
/// head.
double jitter_mm(const RunRecord& run);

/// Index of the first frame in which a moved camera was reported; nothing if it never was.
std::optional<std::size_t> cameraNoticedAt(const RunRecord& run);

}  // namespace facenav::evaluation
