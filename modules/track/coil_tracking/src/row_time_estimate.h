#pragma once
// RowTimeEstimate: the row times of both cameras (rolling shutter), measured while the coil moves. Its print
// is then sheared and stretched by the rows' delay, in proportion to its speed. Many frames with motion in
// different directions tell the row time from what lens and print do.

#include <Eigen/Core>

#include "facenav/cameras/stereo_rig.h"
#include "marker_fit.h"

namespace facenav::coil_tracking {

class RowTimeEstimate {
 public:
  /// Starts anew with the times that the rig states; 0: not known.
  void start(const cameras::StereoRig& rig);
  /// `assumed`: the row times of the rig that the frame was fitted with.
  void add(const RowTimeEquations& seen, const cameras::StereoRig& assumed);
  /// Puts into `rig` the measured times where they are certain, else the stated ones.
  void applyTo(cameras::StereoRig& rig) const;

 private:
  int rows_ = 1;
  Eigen::Vector2d stated_s_ = Eigen::Vector2d::Zero();  // left, right
  // Normal equations of the times: what is believed at first, and what was seen, older frames with less
  // weight.
  Eigen::Matrix2d believed_ = Eigen::Matrix2d::Identity(), seen_ = Eigen::Matrix2d::Zero();  // 1/s^2
  Eigen::Vector2d seen_right_ = Eigen::Vector2d::Zero();                                     // 1/s
};

}  // namespace facenav::coil_tracking
