#pragma once
// OffsetFilter: delay of the right camera's exposure after the left one's. Ordinary cameras run free: a pair
// may be up to half a frame apart. A head at 100 mm/s then appears 1.6 mm displaced in the right image, and a
// fit of one pose to both images takes this for depth and rotation. The offset is learnt from the moving
// head: from the displacements that the fit leaves in the right image along the head's velocity, with the
// pose free. A displacement that a change of pose also explains contains no information; vertical motion, and
// depth against size, contain most.
//
// If the cameras' drivers give the delay by their time stamps, the filter starts there and follows them,
// until the moving head contradicts them for long.
//
// A scalar Kalman filter. The variance of a frame's measurement consists of its noise and an error of the
// patches' disparities, common to all patches and to the frames of a tenth of a second. So slow motion, where
// that error looks like delay, has almost no weight. While the offset is uncertain it is drawn to zero
// (synchronous cameras).

#include <optional>

#include "patch_model.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

class OffsetFilter {
 public:
  void reset() { *this = {}; }
  /// Sets the delay of this frame by the drivers' time stamps, s. Call before add().
  void state(double late_s);
  /// The offset to correct for, s; 0 unless it is known to differ from 0.
  double late_s() const;
  double sigma_s() const;
  /// Effect of the offset's uncertainty on the pose of the last added frame: covariance of xi, Head, about
  /// the model's centre.
  Matrix6d poseCovariance() const { return variance_s2_ * by_offset_ * by_offset_.transpose(); }
  /// Adds a tracked frame. `level`: the patches of the fit; `velocity`: the head's velocity minus that when
  /// these patches were learnt, per s, in Head about the model's centre; `allowed`: the motion that the fit
  /// already corrected for (that velocity times the offset then); `since_s`: since the frame before.
  void add(const PatchLevel& level, const PoseFit& fit, const Vector6d& velocity, const Vector6d& allowed,
           double since_s);

 private:
  double offset_s_ = 0.0, variance_s2_ = kPrior_s * kPrior_s;
  Vector6d by_offset_ = Vector6d::Zero();  // d(pose) / d(offset), per s
  int contradicted_ = 0;                   // consecutive contradictions
  std::optional<double> stated_s_;         // smoothed; empty without time stamps
  bool is_statement_wrong_ = false;
  double prior_s() const { return stated_s_ ? kStated_s : kPrior_s; }
  // Standard deviations of the prior. Free cameras: a quarter of a frame's time. With time stamps: start of
  // exposure and arrival differ between makes.
  static constexpr double kPrior_s = 0.008, kStated_s = 0.002;
};

}  // namespace facenav::head_tracking
