#pragma once
// A coil tracker that always returns a marker of 60 mm at rest, 600 mm before the cameras.

#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::testing {

class SeenMarker : public coil_tracking::CoilTracker {
 public:
  /// `rig`: true pose of the cameras. `aside_mm`: offset of the marker's middle along x of the left camera.
  explicit SeenMarker(cameras::StereoRig rig, double aside_mm = 0.0)
      : rig_(std::move(rig)), aside_mm_(aside_mm) {}
  void start(const cameras::StereoRig&, const coil_tracking::CoilModel&) override {}
  coil_tracking::CoilResult track(const cameras::StereoFrame&, const coil_tracking::CoilContext&) override {
    health::SquareObservation seen;
    const Eigen::Vector3d corners_mm[] = {{-30, -30, 600}, {30, -30, 600}, {30, 30, 600}, {-30, 30, 600}};
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d at_mm = corners_mm[i] + aside_mm_ * Eigen::Vector3d::UnitX();
      seen.left_px[i] = cameras::project(rig_.left, at_mm);
      seen.right_px[i] = cameras::project(rig_.right, rig_.right_T_left.isometry() * at_mm);
    }
    seen.size_mm = 60;
    seen.print_sigma_mm = 0.1;
    coil_tracking::CoilResult result{Lost{LostReason::camera}};
    result.observation = seen;
    return result;
  }

 private:
  const cameras::StereoRig rig_;
  const double aside_mm_;
};

}  // namespace facenav::testing
