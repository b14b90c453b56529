#pragma once
// Places of the patches in an image at a pose: input of the patch kernel (patch_kernel.h).

#include "patch_model.h"

namespace facenav::head_tracking {

/// The patches of a level that a camera can see at a pose, its model linearised at their centres.
struct Placed {
  std::vector<patch::Placement> placements;
  std::vector<Eigen::Vector2d> centres_px;    // full resolution
  std::vector<Eigen::Matrix2d> key_from_now;  // for small displacements, pixels of the level
};

/// A rigid motion in the kernel's form: rotation, row by row, then translation (mm).
std::array<float, 12> floatsOf(const Eigen::Isometry3d& pose);

/// A subset of a level's patches: each `every`-th, starting with `first`.
struct PatchShare {
  std::size_t every = 1, first = 0;
};

/// `index`: 0 left, 1 right. Patches that face away or are too foreshortened are left out.
Placed place(const PatchLevel& level, const cameras::CameraModel& camera, int index,
             const Eigen::Isometry3d& camera_T_head, const PatchShare& share = {});

/// Boxes of both images that contain the patches at a pose, grown by `margin_px`.
std::array<cv::Rect, 2> boxesAt(const cameras::StereoRig& rig, const PatchModel& model,
                                const Eigen::Isometry3d& motion, int margin_px);

}  // namespace facenav::head_tracking
