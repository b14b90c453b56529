#pragma once
// The head's pose from the patches: 6 degrees of freedom, minimising the displacements of all patches in both
// images at once (never through triangulated points), as the patch's mean over the cameras and its change of
// disparity, each with its own errors (patch_worth.h); how large each kind's errors are is seen in the frame.
// Robust: iteratively reweighted, Tukey's biweight on the displacement in units of its own standard
// deviation, times the trust in the patch. Light that changes over the face is taken off each patch as its
// neighbours show it (light_field.h).

#include <array>
#include <vector>

#include "patch_model.h"

namespace facenav::head_tracking {

/// One patch as seen by one camera in the current frame.
struct PatchSight {
  bool is_visible = false;
  Eigen::Vector2f displacement =
      Eigen::Vector2f::Zero();                   // of level pixels in the key frame, still to explain
  float ncc = 0.f, expected_ncc = 0.f;           // expected: with noise alone
  float brightness = 1.f;                        // mean grey over that of the key frame
  float weight = 0.f;                            // 0..1, after the fit
  float distance = 0.f;                          // of the fit, in standard deviations
  float residual_px = 0.f;                       // the same in pixels of the level
  Eigen::Vector2f px = Eigen::Vector2f::Zero();  // of the centre in the current image
  bool isGood() const {
    return is_visible && weight > 0.25f && residual_px < 1.f && ncc > 0.7f * expected_ncc;
  }
};
using PatchSights = std::vector<std::array<PatchSight, 2>>;

struct PoseFit {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  // camera_T_head
  Matrix6d information = Matrix6d::Zero();                   // of xi in Head, about the model's centre
  Matrix6d pull = Matrix6d::Zero();  // sum over the face's regions of (their pull on xi) (same)'
  int regions = 0;                   // that pull
  double scale = 1.0;                // spread of distances, in the information; 1 where the model holds
  bool is_settled = false;           // the last step moved no patch by more than a small part of a pixel
  PatchSights sights;                // of level 0; empty where the fit ended above
  int looks = 0;                     // at patches, by all steps: the work
  double likeness = 0.0;  // share of the patches in view, of the last level, that look as they should
};

/// A level with fewer patches is left out: they would throw the pose farther off than it was.
constexpr std::size_t kFewestPatches = 15;

/// Coarse to fine from `start`, beginning at `first_level`. `levels`: the model's, or the same patches as a
/// later key frame shows them. Ends after `last_level`: above 0 a fit costs a fifth, to
/// choose among starts by their likeness. `trust`: one factor per patch of level 0 (or empty); `most_steps`:
/// on level 0.
PoseFit fitPose(const cameras::StereoRig& rig, const PatchModel& model, const PatchLevels& levels,
                const std::array<ImagePyramid, 2>& now, const Eigen::Isometry3d& start, int first_level,
                const std::vector<float>& trust, int last_level = 0, int most_steps = 8);

}  // namespace facenav::head_tracking
