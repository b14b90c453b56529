#include "facenav/stereo/rectification.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "facenav/core/error.h"
#include "rectification/resample.h"

namespace facenav::stereo {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLeastForward = 0.3;  // least cosine: rays up to about 73 degrees from the common axis
constexpr int kMapStep_px = 4;         // the map is exact every 4 px and linear between (error < 0.002 px)

Matrix3d commonOrientation(const cameras::StereoRig& rig) {
  const auto left_T_right = rig.right_T_left.inverse();
  const Vector3d x = left_T_right.translation_mm().normalized();
  const Vector3d forward = (Vector3d::UnitZ() + left_T_right.rotation().col(2)).normalized();
  const Vector3d z = forward - x * x.dot(forward);
  if (z.norm() < kLeastForward)
    throw Error("one camera stands in front of the other", "stereo.yml", "depth needs cameras side by side");
  Matrix3d rectified_R_camera;
  rectified_R_camera.row(2) = z.normalized();
  rectified_R_camera.row(0) = x;
  rectified_R_camera.row(1) = z.normalized().cross(x);
  return rectified_R_camera;
}

// Undistorted border of a part of an image, in normalised coordinates.
std::vector<Vector2d> outline(const cameras::CameraModel& camera, const cv::Rect& part) {
  std::vector<Vector2d> points;
  constexpr int kSteps = 24;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = part.x + (part.width - 1) * double(i) / kSteps,
                 y = part.y + (part.height - 1) * double(i) / kSteps;
    for (const Vector2d& pixel : {Vector2d(x, part.y), Vector2d(x, part.y + part.height - 1),
                                  Vector2d(part.x, y), Vector2d(part.x + part.width - 1, y)})
      points.push_back(undistort(camera, pixel));
  }
  return points;
}

struct Bounds {
  double left = std::numeric_limits<double>::max(), top = left, right = -left, bottom = -left;
  double smallest_z = left,
         largest_z = -left;  // depth in the rectified frame relative to depth in the camera's
};

Bounds boundsInRectified(const Matrix3d& rectified_R_camera, const std::vector<Vector2d>& points) {
  Bounds b;
  for (const Vector2d& point : points) {
    const Vector3d ray = rectified_R_camera * point.homogeneous();
    if (ray.z() < kLeastForward * ray.norm())
      throw Error("the cameras do not look the same way", "stereo.yml",
                  "point both at the head and calibrate again");
    b.left = std::min(b.left, ray.x() / ray.z());
    b.right = std::max(b.right, ray.x() / ray.z());
    b.top = std::min(b.top, ray.y() / ray.z());
    b.bottom = std::max(b.bottom, ray.y() / ray.z());
    b.smallest_z = std::min(b.smallest_z, ray.z());
    b.largest_z = std::max(b.largest_z, ray.z());
  }
  return b;
}

struct RectifiedCamera {
  const cameras::CameraModel& camera;
  Matrix3d camera_R_rectified;
  double f_px, cx_px, cy_px;
  double farthest_radius;  // beyond it the distortion polynomial may fold back into the image

  cv::Vec2f recordedPixel(double x, double y) const {
    const Vector3d ray = camera_R_rectified * Vector3d((x - cx_px) / f_px, (y - cy_px) / f_px, 1);
    constexpr float kOutside = -1e6f;
    if (ray.z() <= 0 || ray.hnormalized().norm() > farthest_radius) return {kOutside, kOutside};
    const Vector2d pixel = project(camera, ray);
    return {float(pixel.x()), float(pixel.y())};
  }
};

cv::Mat makeMap(const RectifiedCamera& view, const cv::Size& size) {
  const int cols = (size.width - 1) / kMapStep_px + 2, rows = (size.height - 1) / kMapStep_px + 2;
  cv::Mat coarse(rows, cols, CV_32FC2), map(size, CV_32FC2);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < cols; ++x)
      coarse.at<cv::Vec2f>(y, x) = view.recordedPixel(x * kMapStep_px, y * kMapStep_px);
  for (int y = 0; y < size.height; ++y) {
    const float fy = float(y % kMapStep_px) / kMapStep_px;
    const cv::Vec2f* above = coarse.ptr<cv::Vec2f>(y / kMapStep_px);
    const cv::Vec2f* below = coarse.ptr<cv::Vec2f>(y / kMapStep_px + 1);
    for (int x = 0; x < size.width; ++x) {
      const int i = x / kMapStep_px;
      const float fx = float(x % kMapStep_px) / kMapStep_px;
      map.at<cv::Vec2f>(y, x) = (above[i] * (1 - fx) + above[i + 1] * fx) * (1 - fy) +
                                (below[i] * (1 - fx) + below[i + 1] * fx) * fy;
    }
  }
  return map;
}

cv::Mat insideMask(const cv::Mat& map, const cv::Rect& part) {
  cv::Mat mask(map.size(), CV_8U);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      const cv::Vec2f p = map.at<cv::Vec2f>(y, x);
      const bool is_inside = p[0] >= float(part.x) && p[1] >= float(part.y) &&
                             p[0] <= float(part.x + part.width - 1) &&
                             p[1] <= float(part.y + part.height - 1);
      mask.at<std::uint8_t>(y, x) = is_inside ? 255 : 0;
    }
  return mask;
}

double largestRadius(const std::vector<Vector2d>& points) {
  double radius = 0;
  for (const Vector2d& point : points) radius = std::max(radius, point.norm());
  return radius * 1.02;
}

}  // namespace

Vector3d Rectification::point_mm(double x_px, double y_px, double disparity_px) const {
  const double z = f_px * baseline_mm / (disparity_px - offset_px());
  const Vector3d rectified((x_px - cx_left_px) * z / f_px, (y_px - cy_px) * z / f_px, z);
  return rectified_R_camera.transpose() * rectified;
}

double Rectification::depthPerDisparity_mm(double disparity_px) const {
  const double plain = disparity_px - offset_px();
  return -f_px * baseline_mm / (plain * plain);
}

Rectification rectify(const cameras::StereoRig& rig, const DepthRange& range, const cv::Rect& left_roi) {
  FACENAV_EXPECT(range.nearest_mm > 0 && range.farthest_mm > range.nearest_mm,
                 "depth range must be positive");
  const cv::Rect whole(0, 0, rig.width_px, rig.height_px);
  const cv::Rect part = left_roi.empty() ? whole : (left_roi & whole);
  if (part.width < 16 || part.height < 16)
    throw Error("the region of interest lies outside the image", "left_roi");
  Rectification r;
  r.rectified_R_camera = commonOrientation(rig);
  r.baseline_mm = rig.baseline_mm();
  r.f_px = std::pow(rig.left.k(0, 0) * rig.left.k(1, 1) * rig.right.k(0, 0) * rig.right.k(1, 1), 0.25);
  const Bounds b = boundsInRectified(r.rectified_R_camera, outline(rig.left, part));
  const cv::Size size(int(std::ceil((b.right - b.left) * r.f_px)) + 1,
                      int(std::ceil((b.bottom - b.top) * r.f_px)) + 1);
  const double most = std::ceil(r.f_px * r.baseline_mm / (range.nearest_mm * b.smallest_z));
  const double least = std::floor(r.f_px * r.baseline_mm / (range.farthest_mm * b.largest_z));
  r.disparities = std::min(int(most - least) + 1, 2048);
  r.cx_left_px = -b.left * r.f_px;
  r.cy_px = -b.top * r.f_px;
  r.cx_right_px = r.cx_left_px + least;

  const Matrix3d right_R_camera = rig.right_T_left.rotation();
  const RectifiedCamera left{rig.left, r.rectified_R_camera.transpose(),       r.f_px, r.cx_left_px,
                             r.cy_px,  largestRadius(outline(rig.left, whole))};
  // The rectified right image starts `disparities` columns further left than the left one.
  const RectifiedCamera right{rig.right, right_R_camera * r.rectified_R_camera.transpose(),
                              r.f_px,    r.cx_right_px + r.disparities,
                              r.cy_px,   largestRadius(outline(rig.right, whole))};
  r.left_map = makeMap(left, size);
  r.right_map = makeMap(right, {size.width + r.disparities, size.height});
  r.left_mask = insideMask(r.left_map, part);
  r.right_mask = insideMask(r.right_map, whole);
  return r;
}

RectifiedPair applyRectification(const Rectification& rectification, const cameras::StereoFrame& frame) {
  return {resampled(frame.left, rectification.left_map), resampled(frame.right, rectification.right_map)};
}

}  // namespace facenav::stereo
