#include "facenav/evaluation/cloud_evaluation.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace facenav::evaluation {
namespace {

constexpr double kSteepest_cos = 0.342;  // 70 degrees off the line of sight
constexpr double kGross_mm = 2.0, kHidden_mm = 2.0, kStep_mm = 8.0;
constexpr int kRim_px = 2;

/// Points of the left depth map in Camera, one per pixel; z = 0 for a pixel without an object.
cv::Mat_<cv::Vec3d> placesOf(const cameras::StereoRig& rig, const cv::Mat& depth_mm) {
  cv::Mat_<cv::Vec3d> places(depth_mm.size(), cv::Vec3d(0, 0, 0));
  for (int y = 0; y < depth_mm.rows; ++y)
    for (int x = 0; x < depth_mm.cols; ++x) {
      const double z = depth_mm.at<float>(y, x);
      if (z <= 0.0) continue;
      const Eigen::Vector2d ray = cameras::undistort(rig.left, {double(x), double(y)});
      places(y, x) = {z * ray.x(), z * ray.y(), z};
    }
  return places;
}

Eigen::Vector3d toEigen(const cv::Vec3d& v) { return {v[0], v[1], v[2]}; }

bool isAtSilhouette(const cv::Mat& depth_mm, int x, int y) {
  const float here = depth_mm.at<float>(y, x);
  for (const auto& [dx, dy] : {std::pair{kRim_px, 0}, {-kRim_px, 0}, {0, kRim_px}, {0, -kRim_px}}) {
    const float there = depth_mm.at<float>(y + dy, x + dx);
    if (there <= 0.f || std::abs(there - here) > kStep_mm) return true;
  }
  return false;
}

/// Returns true if the right camera sees the point too: its depth map has the same distance there.
bool isSeenOnTheRight(const cameras::StereoRig& rig, const cv::Mat& right_mm,
                      const Eigen::Vector3d& p_camera) {
  const Eigen::Vector3d p = (rig.right_T_left * Point<Camera>(p_camera)).mm;
  if (p.z() <= 0.0) return false;
  const Eigen::Vector2d px = cameras::project(rig.right, p);
  const int x = int(std::lround(px.x())), y = int(std::lround(px.y()));
  if (x < 1 || y < 1 || x + 1 >= right_mm.cols || y + 1 >= right_mm.rows) return false;
  double nearest_mm = 1e9;  // steep skin: any of the surrounding pixels may show it
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i)
      nearest_mm = std::min(nearest_mm, std::abs(right_mm.at<float>(y + j, x + i) - p.z()));
  return nearest_mm < kHidden_mm;
}

/// Depth at a position between pixel centres; 0 next to the head.
double depthAt(const ExactDepth& depth, double x_px, double y_px) {
  const int x = int(std::floor(x_px)), y = int(std::floor(y_px));
  if (x < 0 || y < 0 || x + 1 >= depth.left_mm.cols || y + 1 >= depth.left_mm.rows) return 0.0;
  const double fx = x_px - x, fy = y_px - y;
  double sum = 0.0;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const double weight = (i ? fx : 1 - fx) * (j ? fy : 1 - fy);
      if (weight < 1e-9) continue;
      if (!depth.is_head_left.at<std::uint8_t>(y + j, x + i)) return 0.0;
      sum += weight * depth.left_mm.at<float>(y + j, x + i);
    }
  return sum;
}

struct PointError {
  Eigen::Vector3d p_mm;
  double along_ray_mm;
};

struct PatchMean {
  Eigen::Vector3d p_mm = Eigen::Vector3d::Zero();
  double off_mm = 0.0;
  int points = 0;
};

/// Means over cubes of the smallest lag that contain at least 5 points.
std::vector<PatchMean> patchMeans(const std::vector<PointError>& errors) {
  constexpr int kFewest = 5;
  std::map<std::array<int, 3>, PatchMean> cubes;
  for (const PointError& e : errors) {
    std::array<int, 3> cube;
    for (int a = 0; a < 3; ++a) cube[a] = int(std::floor(e.p_mm[a] / CloudFigures::kLags_mm.front()));
    PatchMean& patch = cubes[cube];
    patch.p_mm += e.p_mm, patch.off_mm += e.along_ray_mm, ++patch.points;
  }
  std::vector<PatchMean> means;
  for (auto& [ignored, patch] : cubes)
    if (patch.points >= kFewest)
      means.push_back({patch.p_mm / patch.points, patch.off_mm / patch.points, patch.points});
  return means;
}

void noteShared(const std::vector<PointError>& errors, CloudFigures& figures) {
  const auto patches = patchMeans(errors);
  std::array<double, 4> sums{}, counts{};
  for (std::size_t i = 0; i < patches.size(); ++i) {
    figures.mean_mm += patches[i].off_mm / double(patches.size());
    for (std::size_t j = 0; j < i; ++j) {
      const double apart_mm = (patches[i].p_mm - patches[j].p_mm).norm();
      for (std::size_t lag = 0; lag < sums.size(); ++lag)
        if (apart_mm >= CloudFigures::kLags_mm[lag] && apart_mm < CloudFigures::kLags_mm[lag + 1])
          sums[lag] += patches[i].off_mm * patches[j].off_mm, counts[lag] += 1;
    }
  }
  for (std::size_t lag = 0; lag < sums.size(); ++lag)
    figures.shared_mm2[lag] = counts[lag] > 0 ? sums[lag] / counts[lag] : 0.0;
}

}  // namespace

cv::Mat visibleFace(const cameras::StereoRig& rig, const ExactDepth& depth, const Point<Camera>& face_middle,
                    double reach_mm) {
  const auto places = placesOf(rig, depth.left_mm);
  const Eigen::Vector3d right_eye = rig.right_T_left.inverse().translation_mm();
  cv::Mat visible = cv::Mat::zeros(depth.left_mm.size(), CV_8U);
  for (int y = kRim_px; y + kRim_px < visible.rows; ++y)
    for (int x = kRim_px; x + kRim_px < visible.cols; ++x) {
      const Eigen::Vector3d p = toEigen(places(y, x));
      if (!depth.is_head_left.at<std::uint8_t>(y, x) || (p - face_middle.mm).norm() > reach_mm) continue;
      if (isAtSilhouette(depth.left_mm, x, y)) continue;
      const Eigen::Vector3d along_x = toEigen(places(y, x + 1) - places(y, x - 1)),
                            along_y = toEigen(places(y + 1, x) - places(y - 1, x));
      const Eigen::Vector3d normal = along_y.cross(along_x).normalized();  // towards the camera
      if (normal.dot(-p.normalized()) < kSteepest_cos ||
          normal.dot((right_eye - p).normalized()) < kSteepest_cos)
        continue;
      if (isSeenOnTheRight(rig, depth.right_mm, p)) visible.at<std::uint8_t>(y, x) = 255;
    }
  return visible;
}

CloudFigures evaluateCloud(const cameras::StereoRig& rig, const stereo::FaceCloud& face,
                           const ExactDepth& depth, const cv::Mat& visible) {
  CloudFigures figures;
  cv::Mat covered = cv::Mat::zeros(visible.size(), CV_8U);
  double squares = 0.0, predicted = 0.0;
  int on_face = 0, gross = 0;
  std::vector<PointError> errors;
  for (std::size_t i = 0; i < face.cloud.size(); ++i) {
    const Eigen::Vector2d px = face.left_px[i].cast<double>();
    const int x = int(std::lround(px.x())), y = int(std::lround(px.y()));
    if (x < 0 || y < 0 || x >= visible.cols || y >= visible.rows) continue;
    covered.at<std::uint8_t>(y, x) = 255;
    if (!visible.at<std::uint8_t>(y, x)) continue;
    const double truth_mm = depthAt(depth, px.x(), px.y());
    if (truth_mm <= 0.0) continue;
    const double along = cameras::undistort(rig.left, px).homogeneous().norm();
    const double error_mm = (face.cloud.points_mm[i].z() - truth_mm) * along;
    ++on_face;
    if (std::abs(error_mm) > kGross_mm) {
      ++gross;
      continue;
    }
    errors.push_back({face.cloud.points_mm[i], error_mm});
    squares += error_mm * error_mm;
    predicted += double(face.sigma_mm[i]) * face.sigma_mm[i];
  }
  // Points lie between pixel centres, so a pixel may be empty by rounding. It counts as found if two direct
  // neighbours are.
  int pixels = 0, found = 0;
  for (int y = 1; y + 1 < visible.rows; ++y)
    for (int x = 1; x + 1 < visible.cols; ++x) {
      if (!visible.at<std::uint8_t>(y, x)) continue;
      ++pixels;
      int around = 0;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        around += covered.at<std::uint8_t>(y + dy, x + dx) != 0;
      found += covered.at<std::uint8_t>(y, x) != 0 || around >= 2;
    }
  noteShared(errors, figures);
  figures.points = on_face;
  const double counted = std::max(1, on_face - gross);
  figures.rms_mm = std::sqrt(squares / counted);
  figures.predicted_mm = std::sqrt(predicted / counted);
  figures.gross_percent = 100.0 * gross / std::max(1, on_face);
  figures.coverage_percent = 100.0 * found / std::max(1, pixels);
  return figures;
}

}  // namespace facenav::evaluation
