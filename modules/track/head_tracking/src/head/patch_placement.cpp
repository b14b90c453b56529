#include "patch_placement.h"

#include <Eigen/LU>
#include <cmath>

#include "face_surface.h"

namespace facenav::head_tracking {
std::array<float, 12> floatsOf(const Eigen::Isometry3d& pose) {
  std::array<float, 12> m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) m[3 * r + c] = float(pose.linear()(r, c));
    m[9 + r] = float(pose.translation()(r));
  }
  return m;
}

Placed place(const PatchLevel& level, const cameras::CameraModel& camera, int index,
             const Eigen::Isometry3d& camera_T_head, const PatchShare& share) {
  Placed placed;
  placed.placements.reserve(level.patches.size()), placed.centres_px.reserve(level.patches.size());
  const double scale = 1.0 / (1 << level.level);
  for (std::size_t i = share.first; i < level.patches.size(); i += share.every) {
    const Patch& patch = level.patches[i];
    if (!patch.view[index].is_usable) continue;
    const Eigen::Vector3d centre_mm = camera_T_head * patch.centre_mm;
    if (centre_mm.z() < 1 ||
        -(camera_T_head.linear() * patch.normal).dot(centre_mm) < kGrazing_cos * centre_mm.norm())
      continue;
    Eigen::Matrix<double, 2, 3> d_p;
    const Eigen::Vector2d px = cameras::project(camera, centre_mm, d_p);
    const Eigen::Matrix2d d = scale * centre_mm.z() * d_p.leftCols<2>();
    Eigen::Matrix2d now_from_key;  // in pixels of the left key image
    now_from_key << scale * d_p * (camera_T_head.linear() * patch.right_mm),
        scale * d_p * (camera_T_head.linear() * patch.down_mm);
    if (std::abs(now_from_key.determinant()) < kLeastArea) continue;
    placed.key_from_now.push_back(now_from_key.inverse());
    const Eigen::Vector2d offset = scale * px - d * centre_mm.hnormalized();
    patch::Placement at;
    at.patch = std::int32_t(i);
    at.d[0] = float(d(0, 0)), at.d[1] = float(d(0, 1)), at.d[2] = float(d(1, 0)), at.d[3] = float(d(1, 1));
    at.offset[0] = float(offset.x()), at.offset[1] = float(offset.y());
    placed.placements.push_back(at), placed.centres_px.push_back(px);
  }
  return placed;
}

std::array<cv::Rect, 2> boxesAt(const cameras::StereoRig& rig, const PatchModel& model,
                                const Eigen::Isometry3d& motion, int margin_px) {
  std::array<cv::Rect, 2> boxes;
  for (int c = 0; c < 2; ++c) {
    const Eigen::Isometry3d camera_T_head = c == 0 ? motion : rig.right_T_left.isometry() * motion;
    const Placed placed = place(model.level[0], c == 0 ? rig.left : rig.right, c, camera_T_head);
    if (placed.centres_px.empty()) continue;
    Eigen::Vector2d low = placed.centres_px.front(), high = low;
    for (const auto& px : placed.centres_px) low = low.cwiseMin(px), high = high.cwiseMax(px);
    low = low.cwiseMax(-1e4), high = high.cwiseMin(1e4);
    if ((high - low).minCoeff() < 0) continue;
    boxes[c] = cv::Rect(cv::Point(int(low.x()) - margin_px, int(low.y()) - margin_px),
                        cv::Point(int(high.x()) + margin_px + 1, int(high.y()) + margin_px + 1));
  }
  return boxes;
}

}  // namespace facenav::head_tracking
