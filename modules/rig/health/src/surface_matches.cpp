#include "facenav/health/surface_matches.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "facenav/cameras/patch_match.h"

namespace facenav::health {

std::vector<Correspondence> matchSurface(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                         const PointCloud<Camera>& surface,
                                         const std::vector<Eigen::Vector2f>& left_px, std::size_t most) {
  std::vector<Correspondence> found;
  const std::size_t count = std::min(surface.points_mm.size(), left_px.size());
  const std::size_t tries = 4 * most, step = std::max<std::size_t>(1, count / tries);
  for (std::size_t i = step / 2; i < count && found.size() < most; i += step) {
    const Eigen::Vector3d in_right_mm = rig.right_T_left.isometry() * surface.points_mm[i];
    if (in_right_mm.z() <= 0) continue;
    const Eigen::Vector2d left = left_px[i].cast<double>();
    if (const auto match =
            cameras::matchPatch(frame.left, frame.right, left, cameras::project(rig.right, in_right_mm)))
      found.push_back({left, match->right_px, match->sigma_px});
  }
  return found;
}

std::vector<cv::Point> outlineOf(const std::vector<Eigen::Vector2f>& left_px) {
  std::vector<cv::Point> points, outline;
  for (const auto& px : left_px) points.emplace_back(int(px.x()), int(px.y()));
  if (!points.empty()) cv::convexHull(points, outline);
  return outline;
}

}  // namespace facenav::health
