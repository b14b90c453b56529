#pragma once
// Where the patches lie in an image at a pose: what the patch kernel (patch_kernel.h) needs of pose and
// camera.

#include "patch_model.h"

namespace facenav::head_tracking {

/// All patches of a level that a camera can see at a pose, placed by its model made linear at their centres.
struct Placed {
  std::vector<patch::Placement> placements;
  std::vector<Eigen::Vector2d> centres_px;    // full resolution
  std::vector<Eigen::Matrix2d> key_from_now;  // of small displacements, pixels of the level
};

/// A rigid motion as the kernel takes it: rotation, row by row, then translation (mm).
std::array<float, 12> floatsOf(const Eigen::Isometry3d& pose);

/// Some of a level's patches: every such one, from the first on.
struct PatchShare {
  std::size_t every = 1, first = 0;
};

/// `index`: 0 left, 1 right; patches that face away or are foreshortened too far are left out.
Placed place(const PatchLevel& level, const cameras::CameraModel& camera, int index,
             const Eigen::Isometry3d& camera_T_head, const PatchShare& share = {});

/// The boxes of both images in which the patches lie at a pose, grown by `margin_px`.
std::array<cv::Rect, 2> boxesAt(const cameras::StereoRig& rig, const PatchModel& model,
                                const Eigen::Isometry3d& motion, int margin_px);

}  // namespace facenav::head_tracking
