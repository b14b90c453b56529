#pragma once
// Tracked or lost: what a fitted pose must show before it may be shown. Each camera on its own must see
// enough of the face where the pose puts it, looking as it did (another person, a wrong place: it does not)
// and within a fraction of a pixel (left and right swapped, a frozen camera: it is not), spread widely enough
// to fix all 6 degrees.

#include <optional>

#include "facenav/core/tracked.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

struct Verdict {
  std::optional<LostReason> lost;
  double quality = 0.0;
  Matrix6d covariance = Matrix6d::Zero();         // HeadPose's, of what the pictures show
  Matrix6d unseen_covariance = Matrix6d::Zero();  // the key frame's; stated with the pose, not judged
  std::array<double, 2> good_share = {0, 0};
  bool isTracked() const { return !lost; }
};

/// `key_covariance`: of the key frame's own pose (HeadPose's; zero for the reference). `is_of_moment`: it was
/// learnt where the face was found anew, the pose may be less sure.
Verdict judge(const PatchModel& model, const PoseFit& fit, const Matrix6d& key_covariance = Matrix6d::Zero(),
              bool is_of_moment = false);

}  // namespace facenav::head_tracking
