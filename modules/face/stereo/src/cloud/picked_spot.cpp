#include "facenav/stereo/picked_spot.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"

namespace facenav::stereo {
namespace {

constexpr double kNearestPlace_mm = 150, kFarthestPlace_mm = 2000, kPlaceStep_mm = 4;
constexpr double kPlaceMargin_mm = 25;  // depth searched beyond the possible places
constexpr int kSpotMargin_px = 64;      // pixels around the spot that the matcher needs
constexpr double kAtSpot_px = 2.0;      // points within this distance of the pixel are used
constexpr std::size_t kFewestAtSpot = 5;
constexpr double kJump_mm = 4.0;       // depth step between these points: the edge of a finger, of the nose
constexpr double kLeastFacing = 0.45;  // cosine to either camera; oblique skin is measured poorly

// Limits of the correlation at the measured depth, and of its lead over every other depth. Raising them is
// safe.
constexpr double kLeastLikeness = 0.8, kLeastLead = 0.03;
constexpr double kSameDepth_px = 2.0, kOtherDepth_px = 4.0, kFarthestDepth_px = 25.0, kDepthStep_px = 0.5;
/// Real error of one spot of plain skin, relative to the matcher's predicted deviation.
constexpr double kUnseenError = 1.7;

/// One camera of the pair with its picture.
struct View {
  const cameras::CameraModel& camera;
  const cv::Mat& grey;
  Eigen::Isometry3d view_T_left;
};

/// The surface at the pixel, in the frame of the camera whose picture was clicked.
struct SurfaceAtPixel {
  std::vector<double> depths_mm, sigmas_mm;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// The nearest range of possible places on the line of sight.
std::vector<Point<Camera>> possiblePlaces(const Eigen::Isometry3d& left_T_view, const Eigen::Vector3d& ray,
                                          const std::function<bool(const Point<Camera>&)>& mayLie) {
  std::vector<Point<Camera>> places;
  for (double depth_mm = kNearestPlace_mm; depth_mm < kFarthestPlace_mm; depth_mm += kPlaceStep_mm) {
    const Point<Camera> place(left_T_view * Eigen::Vector3d(depth_mm * ray));
    if (mayLie(place))
      places.push_back(place);
    else if (!places.empty())
      break;
  }
  return places;
}

FaceCloudOptions optionsFor(const cameras::StereoRig& rig, const std::vector<Point<Camera>>& places) {
  const double a_mm = places.front().mm.z(), b_mm = places.back().mm.z();
  auto options = plainFaceOptions();
  options.nearest_mm = std::max(0.5 * kNearestPlace_mm, std::min(a_mm, b_mm) - kPlaceMargin_mm);
  options.farthest_mm = std::max(a_mm, b_mm) + kPlaceMargin_mm;
  options.match.smallest_patch_px = 300;
  const Eigen::Vector2d a = cameras::project(rig.left, places.front().mm),
                        b = cameras::project(rig.left, places.back().mm);
  const Eigen::Vector2d low = a.cwiseMin(b), high = a.cwiseMax(b);
  const cv::Point margin(kSpotMargin_px, kSpotMargin_px);
  options.left_roi = cv::Rect(cv::Point(int(low.x()), int(low.y())) - margin,
                              cv::Point(int(high.x()), int(high.y())) + margin) &
                     cv::Rect(0, 0, rig.width_px, rig.height_px);
  return options;
}

/// The surface at the pixel. Returns nothing if it is not measured there, is oblique, or jumps.
std::optional<SurfaceAtPixel> surfaceAt(const FaceCloud& measured, const View& seen,
                                        const Eigen::Vector2d& px, const Eigen::Vector3d& right_eye_mm) {
  SurfaceAtPixel surface;
  for (std::size_t i = 0; i < measured.cloud.size(); ++i) {
    const Eigen::Vector3d &p_mm = measured.cloud.points_mm[i], &normal = measured.cloud.normals[i];
    const Eigen::Vector3d in_view_mm = seen.view_T_left * p_mm;
    if ((cameras::project(seen.camera, in_view_mm) - px).norm() > kAtSpot_px) continue;
    if (normal.dot(-p_mm.normalized()) < kLeastFacing ||
        normal.dot((right_eye_mm - p_mm).normalized()) < kLeastFacing)
      return std::nullopt;
    surface.depths_mm.push_back(in_view_mm.z());
    surface.sigmas_mm.push_back(measured.sigma_mm[i]);
    surface.normal += seen.view_T_left.linear() * normal;
  }
  if (surface.depths_mm.size() < kFewestAtSpot) return std::nullopt;
  const auto [nearest, farthest] = std::minmax_element(surface.depths_mm.begin(), surface.depths_mm.end());
  if (*farthest - *nearest > kJump_mm) return std::nullopt;
  surface.normal.normalize();
  return surface;
}

/// Similarity of a flat piece of skin around the pixel in both pictures, at an assumed depth.
class Likeness {
 public:
  /// `normal`: of the piece, in the frame of the camera `seen`.
  Likeness(const View& seen, const View& other, const Eigen::Vector2d& px, const Eigen::Vector3d& normal)
      : other_(other), other_T_seen_(other.view_T_left * seen.view_T_left.inverse()) {
    constexpr int kHalf_px = 16, kStep_px = 2;
    const double middle = normal.dot(cameras::undistort(seen.camera, px).homogeneous());
    cv::Mat map(0, 1, CV_32FC2);
    for (int v = -kHalf_px; v <= kHalf_px; v += kStep_px)
      for (int u = -kHalf_px; u <= kHalf_px; u += kStep_px) {
        const Eigen::Vector2d at = px + Eigen::Vector2d(u, v);
        const Eigen::Vector3d ray = cameras::undistort(seen.camera, at).homogeneous();
        piece_.push_back(ray * (middle / normal.dot(ray)));
        map.push_back(cv::Vec2f(float(at.x()), float(at.y())));
      }
    cv::remap(seen.grey, grey_, map, {}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  }
  /// Normalised correlation.
  double at(double depth_mm) const {
    cv::Mat map(0, 1, CV_32FC2), there, correlation;
    for (const auto& place : piece_) {
      const Eigen::Vector2d px =
          cameras::project(other_.camera, other_T_seen_ * Eigen::Vector3d(depth_mm * place));
      map.push_back(cv::Vec2f(float(px.x()), float(px.y())));
    }
    cv::remap(other_.grey, there, map, {}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::matchTemplate(there, grey_, correlation, cv::TM_CCOEFF_NORMED);
    return correlation.at<float>(0, 0);
  }

 private:
  View other_;
  Eigen::Isometry3d other_T_seen_;
  std::vector<Eigen::Vector3d> piece_;  // at depth 1 on the pixel's line of sight
  cv::Mat grey_;
};

/// True if the spot looks alike at this depth, and clearly less so at every other.
bool isOnlyDepth(const Likeness& likeness, double depth_mm, double mm_per_px) {
  const double here = likeness.at(depth_mm);
  if (here < kLeastLikeness) return false;
  double best = -1, best_px = 0, other = -1;
  for (double off_px = -kFarthestDepth_px; off_px <= kFarthestDepth_px; off_px += kDepthStep_px) {
    const double alike = likeness.at(depth_mm + off_px * mm_per_px);
    if (alike > best) best = alike, best_px = off_px;
    if (std::abs(off_px) > kOtherDepth_px) other = std::max(other, alike);
  }
  return std::abs(best_px) < kSameDepth_px && here - other > kLeastLead;
}

}  // namespace

std::optional<PickedSpot> measurePickedSpot(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                                            PictureSide side, const Eigen::Vector2d& px,
                                            const std::function<bool(const Point<Camera>&)>& mayLie) {
  if (!(px.x() >= 0 && px.y() >= 0 && px.x() <= rig.width_px - 1 && px.y() <= rig.height_px - 1))
    throw Error("the spot lies outside the picture");
  const View left{rig.left, frame.left, Eigen::Isometry3d::Identity()},
      right{rig.right, frame.right, rig.right_T_left.isometry()};
  const View &seen = side == PictureSide::left ? left : right,
             &other = side == PictureSide::left ? right : left;
  const Eigen::Isometry3d left_T_view = seen.view_T_left.inverse();
  const Eigen::Vector3d ray = cameras::undistort(seen.camera, px).homogeneous();
  const auto places = possiblePlaces(left_T_view, ray, mayLie);
  if (places.empty()) return std::nullopt;
  const auto options = optionsFor(rig, places);
  if (options.left_roi->empty()) return std::nullopt;
  TaskMonitor monitor;
  const auto surface = surfaceAt(measureFace(rig, frame, options, monitor), seen, px,
                                 rig.right_T_left.inverse().translation_mm());
  if (!surface) return std::nullopt;
  const double depth_mm = median(surface->depths_mm);
  const PickedSpot spot{Point<Camera>(left_T_view * Eigen::Vector3d(depth_mm * ray)),
                        kUnseenError * median(surface->sigmas_mm)};
  const double mm_per_px = depth_mm * depth_mm / (seen.camera.k(0, 0) * rig.baseline_mm());
  if (!mayLie(spot.point) || !isOnlyDepth({seen, other, px, surface->normal}, depth_mm, mm_per_px))
    return std::nullopt;
  return spot;
}

}  // namespace facenav::stereo
