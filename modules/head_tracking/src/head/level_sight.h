#pragma once
// LevelSight: the patches of one level as both cameras see them at a pose: where they lie, whether they look
// as they should, and the displacement each still shows. Light that changes over the face is taken off each
// patch as its neighbours show it (light_field.h).

#include <array>
#include <vector>

#include "patch_placement.h"
#include "pose_fit.h"

namespace facenav::head_tracking {

class LevelSight {
 public:
  /// All must outlive it. `now`: the pictures, of this level at least.
  LevelSight(const cameras::StereoRig& rig, const PatchModel& model, const PatchLevel& level,
             const std::array<ImagePyramid, 2>& now);

  /// The cameras made linear at each patch, for poses near this one.
  void placeAt(const Eigen::Isometry3d& motion);
  const std::array<Placed, 2>& placed() const { return placed_; }
  void look(const Eigen::Isometry3d& motion);
  /// Where the patches' centres lie at the fit's end.
  void markCentres(const Eigen::Isometry3d& motion);

  PatchSights& sights() { return sights_; }
  const PatchSights& sights() const { return sights_; }
  /// Share of the patches in view that look as they should.
  double likeness() const;
  /// How unevenly the face's brightness has changed since the key frame: half the middle 68 %.
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
  PatchSights sights_;
  int looks_ = 0;
  std::array<std::vector<Eigen::Vector2f>, 2> light_slopes_;
};

}  // namespace facenav::head_tracking
