#include "facenav/cameras/picked_spot.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "facenav/cameras/patch_match.h"
#include "facenav/core/error.h"

namespace facenav::cameras {
namespace {

constexpr int kSpotSide_px = 21;
constexpr double kNearestDepth_mm = 150, kFarthestDepth_mm = 2000;
constexpr double kLeastFit = 0.6;    // normalised correlation along the line; the refined match asks for more
constexpr double kSecondFit = 0.06;  // a second place must fit less well by this
constexpr double kSamePlace_px = 6;  // fits of one place lie within
constexpr double kOffLine_px = 1.0;  // of the refined match

/// One camera of the pair, with its picture.
struct SpotView {
  const CameraModel& camera;
  const cv::Mat& grey;
  Eigen::Isometry3d view_T_camera;
};

struct FitAtPlace {
  Eigen::Vector2d px;
  double correlation;
};

cv::Mat spotPatch(const cv::Mat& grey, const Eigen::Vector2d& px) {
  cv::Mat patch;
  cv::getRectSubPix(grey, {kSpotSide_px, kSpotSide_px}, cv::Point2f(float(px.x()), float(px.y())), patch,
                    CV_32F);
  patch -= cv::mean(patch)[0];
  const double norm = cv::norm(patch);
  return norm > 0 ? cv::Mat(patch / norm) : patch;
}

/// Where the patch fits, about a pixel apart along the line of sight's picture in the other camera.
std::vector<FitAtPlace> fitsAlongLine(const SpotView& seen, const SpotView& other, const Eigen::Vector2d& px,
                                      double baseline_mm,
                                      const std::function<bool(const Point<Camera>&)>& mayLie) {
  const cv::Mat wanted = spotPatch(seen.grey, px);
  const Eigen::Vector3d ray = undistort(seen.camera, px).homogeneous();
  const Eigen::Isometry3d camera_T_seen = seen.view_T_camera.inverse();
  const double step = 1.0 / (other.camera.k(0, 0) * baseline_mm);  // of 1/depth: about a pixel
  const cv::Rect2d inside(0, 0, other.grey.cols - 1, other.grey.rows - 1);
  std::vector<FitAtPlace> fits;
  for (double inverse = 1 / kFarthestDepth_mm; inverse < 1 / kNearestDepth_mm; inverse += step) {
    const Eigen::Vector3d p_mm = camera_T_seen * Eigen::Vector3d(ray / inverse);
    const Eigen::Vector3d in_other_mm = other.view_T_camera * p_mm;
    if (in_other_mm.z() < kNearestDepth_mm / 2 || !mayLie(Point<Camera>(p_mm))) continue;
    const Eigen::Vector2d at = project(other.camera, in_other_mm);
    if (inside.contains({at.x(), at.y()})) fits.push_back({at, wanted.dot(spotPatch(other.grey, at))});
  }
  return fits;
}

/// The best fit, where no other place fits nearly as well.
std::optional<Eigen::Vector2d> onlyFit(const std::vector<FitAtPlace>& fits) {
  const auto best = std::max_element(fits.begin(), fits.end(), [](const FitAtPlace& a, const FitAtPlace& b) {
    return a.correlation < b.correlation;
  });
  if (best == fits.end() || best->correlation < kLeastFit) return std::nullopt;
  for (const auto& fit : fits)
    if ((fit.px - best->px).norm() > kSamePlace_px && fit.correlation > best->correlation - kSecondFit)
      return std::nullopt;
  return best->px;
}

}  // namespace

std::optional<PickedSpot> measurePickedSpot(const StereoRig& rig, const StereoFrame& frame, PictureSide side,
                                            const Eigen::Vector2d& px,
                                            const std::function<bool(const Point<Camera>&)>& mayLie) {
  const bool is_left = side == PictureSide::left;
  if (!(px.x() >= 0 && px.y() >= 0 && px.x() <= rig.width_px - 1 && px.y() <= rig.height_px - 1))
    throw Error("the spot lies outside the picture");
  const SpotView left{rig.left, frame.left, Eigen::Isometry3d::Identity()},
      right{rig.right, frame.right, rig.right_T_left.isometry()};
  const SpotView &seen = is_left ? left : right, &other = is_left ? right : left;
  const auto start = onlyFit(fitsAlongLine(seen, other, px, rig.baseline_mm(), mayLie));
  if (!start) return std::nullopt;
  const auto match = matchPatch(seen.grey, other.grey, px, *start);
  if (!match) return std::nullopt;
  const Eigen::Vector2d &left_px = is_left ? px : match->right_px, &right_px = is_left ? match->right_px : px;
  if (epipolarError_px(rig, left_px, right_px) > kOffLine_px) return std::nullopt;
  const Point<Camera> point = triangulate(rig, left_px, right_px);
  const double depth_mm = (seen.view_T_camera * point.mm).z();
  const double mm_per_px = depth_mm * depth_mm / (seen.camera.k(0, 0) * rig.baseline_mm());
  return PickedSpot{point, match->sigma_px * mm_per_px};
}

}  // namespace facenav::cameras
