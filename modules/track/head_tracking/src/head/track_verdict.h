#pragma once
// Verdict: tracked or lost, by tests of a fitted pose. Each camera alone must see enough of the face at the
// pose. It must look as expected (fails for another person or a wrong place) and lie within a fraction of a
// pixel (fails for exchanged images or a frozen camera). The visible part must be large enough to determine
// all 6 degrees of freedom.

#include <optional>

#include "facenav/core/tracked.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

struct Verdict {
  std::optional<LostReason> lost;
  double quality = 0.0;
  Matrix6d covariance = Matrix6d::Zero();         // as in HeadPose, from what the images show
  Matrix6d unseen_covariance = Matrix6d::Zero();  // of the key frame; added to the pose's, but not tested
  int key_number = 0;                             // KeyFrame::number
  std::array<double, 2> good_share = {0, 0};
  bool isTracked() const { return !lost; }
};

/// `key_covariance`: of the key frame's own pose (as in HeadPose; zero for the reference). `is_of_moment`:
/// the key frame was learnt when the face was found again, so a larger error is allowed.
Verdict judge(const PatchModel& model, const PoseFit& fit, const Matrix6d& key_covariance = Matrix6d::Zero(),
              bool is_of_moment = false);

}  // namespace facenav::head_tracking
