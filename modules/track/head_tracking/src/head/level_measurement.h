#pragma once
// LevelMeasurement: the patches of one level in both cameras' images at a pose: their places, whether they
// look as expected, and the remaining displacement. The change of light over the face, measured by a patch's
// neighbours, is subtracted (light_field.h).

#include <array>
#include <vector>

#include "patch_placement.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

class LevelMeasurement {
 public:
  /// All arguments must outlive it. `now`: pyramids with at least this level.
  LevelMeasurement(const cameras::StereoRig& rig, const PatchModel& model, const PatchLevel& level,
                   const std::array<ImagePyramid, 2>& now);

  /// Linearises the cameras at each patch, for poses near this one.
  void placeAt(const Eigen::Isometry3d& motion);
  const std::array<Placed, 2>& placed() const { return placed_; }
  void measure(const Eigen::Isometry3d& motion);
  /// Computes the places of the patches' centres at the end of the fit.
  void markCentres(const Eigen::Isometry3d& motion);

  PatchMeasurements& measurements() { return measurements_; }
  const PatchMeasurements& measurements() const { return measurements_; }
  /// Fraction of the patches in view that look as expected.
  double likeness() const;
  /// Unevenness of the change of brightness over the face since the key frame: half the range of the middle
  /// 68 %.
  double lightChange() const;

 private:
  void see(int camera, std::size_t k);
  void displace(int camera, std::size_t k);

  const cameras::StereoRig& rig_;
  const PatchModel& model_;
  const PatchLevel& level_;
  std::array<patch::Image, 2> images_;
  float noise_share_ = 0.f;
  std::array<Placed, 2> placed_;
  std::array<std::vector<patch::Sums>, 2> sums_;
  PatchMeasurements measurements_;
  int rounds_ = 0;
  std::array<std::vector<Eigen::Vector2f>, 2> light_slopes_;
};

}  // namespace facenav::head_tracking
