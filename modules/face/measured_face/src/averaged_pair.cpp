#include "averaged_pair.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "facenav/core/parallel_for.h"
#include "facenav/geometry/rotation.h"

namespace facenav::measured_face {
namespace {

constexpr std::size_t kMostFrames = 30;  // the noise left is then a fifth
constexpr double kMostTurn_rad = 10.0 * kRadPerDeg;
constexpr double kSurfaceBlur_px = 3.0;  // fills holes and takes the depths' noise away
constexpr float kLeastSurface = 0.3f;    // share of measured pixels in that blur

/// Points of the face seen at each pixel of a camera, in Camera, mm; z is 0 beside the face. 3 channels,
/// float.
cv::Mat pointsSeen(const PointCloud<Camera>& surface, const cameras::CameraModel& camera,
                   const Eigen::Isometry3d& camera_T_left, const cv::Size& size) {
  cv::Mat depth(size, CV_32F, cv::Scalar(0)), is_seen(size, CV_32F, cv::Scalar(0));
  for (const Eigen::Vector3d& p : surface.points_mm) {
    const Eigen::Vector3d here = camera_T_left * p;
    if (!(here.z() > 1)) continue;
    const Eigen::Vector2d px = cameras::project(camera, here);
    const cv::Point at(int(std::lround(px.x())), int(std::lround(px.y())));
    if (!at.inside({{}, size})) continue;
    float& nearest = depth.at<float>(at);
    if (nearest == 0 || float(here.z()) < nearest) nearest = float(here.z());
    is_seen.at<float>(at) = 1;
  }
  cv::GaussianBlur(depth, depth, {}, kSurfaceBlur_px);
  cv::GaussianBlur(is_seen, is_seen, {}, kSurfaceBlur_px);
  const Eigen::Isometry3d left_T_camera = camera_T_left.inverse();
  cv::Mat points(size, CV_32FC3, cv::Scalar(0, 0, 0));
  parallelRanges(0, size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < size.width; ++x) {
        if (is_seen.at<float>(y, x) < kLeastSurface) continue;
        const double z = double(depth.at<float>(y, x) / is_seen.at<float>(y, x));
        const Eigen::Vector2d ray = cameras::undistort(camera, Eigen::Vector2d(x, y));
        const Eigen::Vector3f p =
            (left_T_camera * Eigen::Vector3d(ray.x() * z, ray.y() * z, z)).cast<float>();
        points.at<cv::Vec3f>(y, x) = {p.x(), p.y(), p.z()};
      }
  });
  return points;
}

/// Adds the picture at the places to which the points moved, and counts the pixels.
void addMoved(const cv::Mat& picture, const cv::Mat& points, const cameras::CameraModel& camera,
              const Eigen::Isometry3d& camera_T_first, cv::Mat& sum, cv::Mat& count) {
  cv::Mat place(points.size(), CV_32FC2, cv::Scalar(-1, -1));
  parallelRanges(0, points.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < points.cols; ++x) {
        const cv::Vec3f& p = points.at<cv::Vec3f>(y, x);
        if (p[2] == 0) continue;
        const Eigen::Vector2d px =
            cameras::project(camera, camera_T_first * Eigen::Vector3d(p[0], p[1], p[2]));
        if (px.x() >= 1 && px.y() >= 1 && px.x() < picture.cols - 2 && px.y() < picture.rows - 2)
          place.at<cv::Vec2f>(y, x) = {float(px.x()), float(px.y())};
      }
  });
  cv::Mat moved, xs;
  cv::remap(picture, moved, place, cv::noArray(), cv::INTER_CUBIC, cv::BORDER_CONSTANT, 0);
  moved.convertTo(moved, CV_32F);
  cv::extractChannel(place, xs, 0);
  const cv::Mat is_there = xs >= 0;
  cv::add(sum, moved, sum, is_there);
  cv::add(count, cv::Scalar(1), count, is_there);
}

}  // namespace

void AveragedPair::add(const cameras::StereoFrame& frame, const Eigen::Isometry3d& now_T_first) {
  if (frames_.size() >= kMostFrames || rotationAngle(now_T_first.linear()) > kMostTurn_rad) return;
  frames_.push_back({frame, now_T_first});
}

cv::Mat AveragedPair::averaged(const PointCloud<Camera>& surface, bool is_right) const {
  const cameras::CameraModel& camera = is_right ? rig_.right : rig_.left;
  const Eigen::Isometry3d camera_T_left =
      is_right ? rig_.right_T_left.isometry() : Eigen::Isometry3d::Identity();
  const auto pictureOf = [is_right](const Kept& kept) -> const cv::Mat& {
    return is_right ? kept.frame.right : kept.frame.left;
  };
  cv::Mat sum, average;
  pictureOf(frames_.front()).convertTo(sum, CV_32F);
  cv::Mat count(sum.size(), CV_32F, cv::Scalar(1));
  const cv::Mat points = pointsSeen(surface, camera, camera_T_left, sum.size());
  for (std::size_t i = 1; i < frames_.size(); ++i)
    addMoved(pictureOf(frames_[i]), points, camera, camera_T_left * frames_[i].now_T_first, sum, count);
  cv::divide(sum, count, sum);
  sum.convertTo(average, CV_8U);
  return average;
}

cameras::StereoFrame AveragedPair::averaged(const PointCloud<Camera>& surface) const {
  cameras::StereoFrame pair = frames_.front().frame;
  pair.left = averaged(surface, false);
  pair.right = averaged(surface, true);
  return pair;
}

}  // namespace facenav::measured_face
