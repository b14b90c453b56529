#include "facenav/health/surface_matches.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "facenav/cameras/patch_match.h"

namespace facenav::health {
namespace {

constexpr std::size_t kEnough = 600, kMostTries = 4 * kEnough;

}  // namespace

std::vector<Correspondence> matchSurface(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                         const PointCloud<Camera>& surface,
                                         const std::vector<Eigen::Vector2f>& left_px,
                                         const std::vector<cv::Point>& outline) {
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < std::min(surface.points_mm.size(), left_px.size()); ++i)
    if (isInside(outline, left_px[i].cast<double>())) inside.push_back(i);
  std::vector<Correspondence> found;
  const std::size_t step = std::max<std::size_t>(1, inside.size() / kMostTries);
  for (std::size_t k = step / 2; k < inside.size() && found.size() < kEnough; k += step) {
    const std::size_t i = inside[k];
    const Eigen::Vector3d in_right_mm = rig.right_T_left.isometry() * surface.points_mm[i];
    if (in_right_mm.z() <= 0) continue;
    const Eigen::Vector2d left = left_px[i].cast<double>();
    if (const auto match =
            cameras::matchPatch(frame.left, frame.right, left, cameras::project(rig.right, in_right_mm)))
      found.push_back({left, match->right_px, match->sigma_px});
  }
  return found;
}

bool isInside(const std::vector<cv::Point>& outline, const Eigen::Vector2d& left_px) {
  return outline.empty() ||
         cv::pointPolygonTest(outline, {float(left_px.x()), float(left_px.y())}, false) >= 0;
}

std::vector<cv::Point> outlineOf(const std::vector<Eigen::Vector2f>& left_px) {
  std::vector<cv::Point> points, outline;
  for (const auto& px : left_px) points.emplace_back(int(px.x()), int(px.y()));
  if (!points.empty()) cv::convexHull(points, outline);
  return outline;
}

}  // namespace facenav::health
