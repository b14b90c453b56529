#pragma once
// Compares tracked poses with the truth, frame by frame: the errors at a point of clinical interest, the lost
// frames, and the frames in which a wrong pose was reported as tracked (> 3 mm at the point or > 2 degrees).
// Such frames must not occur.

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <vector>

#include "facenav/evaluation/error_statistics.h"

namespace facenav::evaluation {

/// Estimate of one frame; absent when lost.
struct PoseEstimate {
  std::int64_t frame = 0;
  bool is_tracked = false;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

struct FrameError {
  std::int64_t frame = 0;
  double rotation_deg = 0;                                       // angle between estimate and truth
  double translation_mm = 0;                                     // of the pose's origin
  double at_point_mm = 0;                                        // at the given point
  Eigen::Vector3d rotation_about_deg = Eigen::Vector3d::Zero();  // rotation vector of the error, in To axes
  Eigen::Vector3d shift_mm = Eigen::Vector3d::Zero();            // of the point, along To axes
};

struct TrackingEvaluation {
  int frames = 0, tracked = 0, lost = 0, wrong_as_tracked = 0;
  ErrorStatistics rotation_deg, translation_mm, at_point_mm;
  std::vector<FrameError> errors;  // of the tracked frames that have a truth
};

/// Compares estimates with the truth. `point_mm`: in the From frame of the poses (Mri for the head, Marker or
/// Coil for the coil).
TrackingEvaluation evaluateTracking(const std::vector<PoseEstimate>& estimates,
                                    const std::map<std::int64_t, Eigen::Isometry3d>& truth,
                                    const Eigen::Vector3d& point_mm);

}  // namespace facenav::evaluation
