#pragma once
// PoseFit: the head's pose from the patches. Minimises the displacements of all patches in both images at
// once, over 6 degrees of freedom, without triangulated points. A patch contributes its mean over the cameras
// and its change of disparity, each with its own errors (patch_observation.h); the frame itself shows how
// large the errors of each kind are. Iteratively reweighted: Tukey's biweight on the displacement in its own
// standard deviations, times the weight of the patch. Changes of light over the face, measured by a patch's
// neighbours, are subtracted (light_field.h).

#include <array>
#include <optional>
#include <vector>

#include "patch_model.h"
#include "stereo_consistency.h"

namespace facenav::head_tracking {

/// One patch in one camera's current image.
struct PatchMeasurement {
  bool is_visible = false;
  Eigen::Vector2f displacement =
      Eigen::Vector2f::Zero();                   // remaining displacement, in level pixels of the key frame
  float ncc = 0.f, expected_ncc = 0.f;           // expected: with noise alone
  float brightness = 1.f;                        // mean grey relative to the key frame's
  float weight = 0.f;                            // 0..1, after the fit
  float distance = 0.f;                          // residual, in standard deviations
  float residual_px = 0.f;                       // residual, in pixels of the level
  Eigen::Vector2f px = Eigen::Vector2f::Zero();  // centre in the current image
  bool isGood() const {
    return is_visible && weight > 0.25f && residual_px < 1.f && ncc > 0.7f * expected_ncc;
  }
};
using PatchMeasurements = std::vector<std::array<PatchMeasurement, 2>>;

struct PoseFit {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  // camera_T_head
  Matrix6d information = Matrix6d::Zero();                   // of xi in Head, about the model's centre
  Matrix6d pull =
      Matrix6d::Zero();  // sum over the face's regions of g g', g: the region's gradient with respect to xi
  int regions = 0;       // regions that contribute
  double scale = 1.0;    // spread of the normalised residuals; 1 if the error model holds
  bool is_settled = false;         // the last step moved no patch by more than a fraction of a pixel
  PatchMeasurements measurements;  // of level 0; empty if the fit ended at a coarser level
  std::optional<SidesFit> sides;   // pose of the right camera relative to the left one, since the key frame
  int comparisons = 0;             // patch comparisons of all steps: the work
  double likeness = 0.0;           // fraction of the patches in view that look as expected, last level
};

/// A level with fewer patches is skipped: it would make the pose worse. As many must look as expected in each
/// camera, and so large a share of those in view.
constexpr std::size_t kFewestPatches = 15;
constexpr double kLeastGoodShare = 0.25;
/// From this likeness on the head is probably there.
constexpr double kLikely = 0.8;
/// Scale of the residuals (PoseFit::scale) on skin that has not moved is less; another expression has 3 or
/// more.
constexpr double kAsExpected = 2.0;

/// Fits coarse to fine from `start`, beginning at `first_level`. `levels`: the model's, or the same patches
/// in a later key frame. Ends after `last_level`; above 0 a fit costs a fifth, enough to choose among starts
/// by likeness. `trust`: one weight per patch of level 0 (or empty). `most_steps`: on level 0.
PoseFit fitPose(const cameras::StereoRig& rig, const PatchModel& model, const PatchLevels& levels,
                const std::array<ImagePyramid, 2>& now, const Eigen::Isometry3d& start, int first_level,
                const std::vector<float>& patch_weights, int last_level = 0, int most_steps = 8);

}  // namespace facenav::head_tracking
