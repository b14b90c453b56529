#pragma once
// The head's pose from the patches: 6 degrees of freedom, minimising the displacements of all patches in both
// images at once (never through triangulated points). Robust: iteratively reweighted, Tukey's biweight on the
// displacement in units of its own standard deviation, times the trust in the patch.

#include <array>
#include <vector>

#include "patch_model.h"

namespace facenav::tracking {

/// One patch as seen by one camera in the current frame.
struct PatchSight {
  bool is_visible = false;
  Eigen::Vector2d displacement =
      Eigen::Vector2d::Zero();                   // of level pixels in the key frame, still to explain
  float ncc = 0.f, expected_ncc = 0.f;           // expected: with noise alone
  double weight = 0.0;                           // 0..1, after the fit
  double distance = 0.0;                         // of the fit, in standard deviations
  double residual_px = 0.0;                      // the same in pixels of the level
  Eigen::Vector2d px = Eigen::Vector2d::Zero();  // of the centre in the current image
  bool isGood() const {
    return is_visible && weight > 0.25 && residual_px < 1.0 && ncc > 0.7f * expected_ncc;
  }
};
using PatchSights = std::vector<std::array<PatchSight, 2>>;

struct PoseFit {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  // camera_T_head
  Matrix6d information = Matrix6d::Zero();                   // of xi in Head, about the model's centre
  double scale = 1.0;  // spread of distances; 1 where the error model holds
  PatchSights sights;  // of level 0
};

/// Coarse to fine from `start`, beginning at `first_level`. `trust`: one factor per patch of level 0 (or
/// empty).
PoseFit fitPose(const stereo::StereoRig& rig, const PatchModel& model, const std::array<ImagePyramid, 2>& now,
                const Eigen::Isometry3d& start, int first_level, const std::vector<double>& trust);

}  // namespace facenav::tracking
