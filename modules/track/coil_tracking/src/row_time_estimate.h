#pragma once
// RowTimeEstimate: the row times of both cameras (rolling shutter), measured while the coil moves. The delay
// of the rows shears and stretches its print in proportion to its speed. Many frames with motion in different
// directions separate the row time from errors of lens and print.

#include <Eigen/Core>

#include "facenav/cameras/stereo_rig.h"
#include "marker_fit.h"

namespace facenav::coil_tracking {

class RowTimeEstimate {
 public:
  /// Resets to the row times of the rig; 0: unknown.
  void start(const cameras::StereoRig& rig);
  /// `assumed`: the row times of the rig that the frame was fitted with.
  void add(const RowTimeEquations& seen, const cameras::StereoRig& assumed);
  /// Sets the row times of `rig` to the measured ones if they are certain, else to the rig's original ones.
  void applyTo(cameras::StereoRig& rig) const;

 private:
  int rows_ = 1;
  Eigen::Vector2d stated_s_ = Eigen::Vector2d::Zero();  // of the rig: left, right
  // Normal equations of the times: of the prior, and of the observations, older frames with less weight.
  Eigen::Matrix2d believed_ = Eigen::Matrix2d::Identity(), seen_ = Eigen::Matrix2d::Zero();  // 1/s^2
  Eigen::Vector2d seen_right_ = Eigen::Vector2d::Zero();                                     // 1/s
};

}  // namespace facenav::coil_tracking
