#pragma once
// OffsetFilter: how much later the right camera exposes than the left one. Ordinary cameras run free: a pair
// may be up to half a frame apart, and a head at 100 mm/s then stands 1.6 mm elsewhere in the right image,
// which a fit of one pose to both images takes for depth and rotation. The offset is learnt from the moving
// head itself: the displacements that the fit leaves in the right image, along the head's velocity, with the
// pose free. What the velocity does like a change of pose says nothing; vertical motion, and depth against
// size, say most.
//
// A scalar Kalman filter. A frame's measurement counts by its noise and by an error of the patches'
// disparities that all patches and the frames of a third of a second share; so slow motion, in which that
// error passes for delay, hardly counts. Until the offset is certain it is drawn to zero, synchronous
// cameras.

#include <optional>

#include "patch_model.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

class OffsetFilter {
 public:
  void reset() { *this = {}; }
  /// The offset to allow for, s; 0 while it is not known to differ from 0.
  double late_s() const;
  double sigma_s() const;
  /// What the uncertain offset does to the pose of the last frame added: covariance of xi, Head, about the
  /// model's centre.
  Matrix6d poseCovariance() const { return variance_s2_ * by_offset_ * by_offset_.transpose(); }
  /// A tracked frame. `level`: the patches the fit was made with; `velocity`: the head's now, less what it
  /// was when those patches were learnt, per s, in Head about the model's centre; `allowed`: what the fit
  /// allowed for already, that velocity times offset then; `since_s`: since the frame before.
  void add(const PatchLevel& level, const PoseFit& fit, const Vector6d& velocity, const Vector6d& allowed,
           double since_s);

 private:
  double offset_s_ = 0.0, variance_s2_ = kPrior_s * kPrior_s;
  Vector6d by_offset_ = Vector6d::Zero();  // d(pose) / d(offset), per s
  int contradicted_ = 0;                   // frames in a row
  static constexpr double kPrior_s = 0.008;
};

}  // namespace facenav::head_tracking
