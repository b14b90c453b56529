#include "face_shape.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"

namespace facenav::head_tracking {
namespace {

constexpr double kNodesAcross = 60.0;   // nodes over the face's width
constexpr double kNodeReach_mm = 60.0;  // depth range in front of and behind the expected face
constexpr int kNodeCell_px = 4, kFewestNodes = 150, kShapeSteps = 25;
constexpr double kStereo_mm = 0.6;  // error shared by neighbours, without dots
constexpr double kFarthest_mm = 12.0, kSettled_mm = 0.01;

// Mean of the measured points in each cell of the left image.
class MeasuredFace {
 public:
  MeasuredFace(const stereo::FaceCloud& cloud, cv::Size size)
      : columns_(size.width / kNodeCell_px + 1), rows_(size.height / kNodeCell_px + 1) {
    sum_mm_.assign(std::size_t(columns_) * std::size_t(rows_), Eigen::Vector4d::Zero());
    for (std::size_t i = 0; i < cloud.cloud.size(); ++i) {
      const int x = int(cloud.left_px[i].x()) / kNodeCell_px, y = int(cloud.left_px[i].y()) / kNodeCell_px;
      if (x >= 0 && y >= 0 && x < columns_ && y < rows_)
        sum_mm_[at(x, y)] += cloud.cloud.points_mm[i].homogeneous();
    }
  }
  std::optional<Eigen::Vector3d> near(const Eigen::Vector2d& px) const {
    const int x = int(px.x()) / kNodeCell_px, y = int(px.y()) / kNodeCell_px;
    if (px.x() < 0 || px.y() < 0 || x >= columns_ || y >= rows_ || sum_mm_[at(x, y)].w() < 3)
      return std::nullopt;
    return Eigen::Vector3d(sum_mm_[at(x, y)].hnormalized());
  }

 private:
  std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(columns_) + std::size_t(x); }
  int columns_, rows_;
  std::vector<Eigen::Vector4d> sum_mm_;  // sum of the points, and in w their number
};

/// Bounds of the expected face: its box in the left image, with a margin, and its depths.
struct FaceBounds {
  Eigen::Vector2d low_px{1e9, 1e9}, high_px{-1e9, -1e9};
  double nearest_mm = 1e9, farthest_mm = 0;

  void add(const Eigen::Vector2d& px, double depth_mm) {
    low_px = low_px.cwiseMin(px), high_px = high_px.cwiseMax(px);
    nearest_mm = std::min(nearest_mm, depth_mm), farthest_mm = std::max(farthest_mm, depth_mm);
  }
  cv::Rect box(const cameras::StereoRig& rig) const {
    const Eigen::Vector2d margin = 0.15 * (high_px - low_px);
    return cv::Rect(cv::Point(int(low_px.x() - margin.x()), int(low_px.y() - margin.y())),
                    cv::Point(int(high_px.x() + margin.x()), int(high_px.y() + margin.y()))) &
           cv::Rect(0, 0, rig.width_px, rig.height_px);
  }
};

/// Measures the face within its bounds; nullopt where too little of it is in view, or it cannot be measured.
std::optional<MeasuredFace> measureWithin(const FaceBounds& bounds, const cameras::StereoRig& rig,
                                          const cameras::StereoFrame& frame) {
  if (!((bounds.high_px - bounds.low_px).maxCoeff() < 1e5)) return std::nullopt;
  stereo::FaceCloudOptions options;
  options.match = stereo::quickSkinOptions();
  options.left_roi = bounds.box(rig);
  options.nearest_mm = std::max(50.0, bounds.nearest_mm - kNodeReach_mm);
  options.farthest_mm = bounds.farthest_mm + kNodeReach_mm;
  if (options.left_roi->area() < 1000) return std::nullopt;
  try {
    TaskMonitor monitor;
    return MeasuredFace(stereo::measureFace(rig, frame, options, monitor), frame.left.size());
  } catch (const Error&) {  // too little texture or too dark: unknown
    return std::nullopt;
  }
}

/// One Gauss-Newton step of the shape to the measured face.
struct ShapeStep {
  Matrix6d h = Matrix6d::Identity() * 1e-6;
  Vector6d g = Vector6d::Zero();
  std::vector<double> distances;

  void add(double off_mm, double mobility_mm, double scale, const Vector6d& j) {
    const double sigma_mm = std::hypot(kStereo_mm, mobility_mm), distance = off_mm / sigma_mm;
    distances.push_back(std::abs(distance));
    const double weight =
        (kStudentFreedom + 1) / (kStudentFreedom + std::pow(distance / scale, 2)) / (sigma_mm * sigma_mm);
    h.noalias() += weight * j * j.transpose();
    g += weight * off_mm * j;
  }
  bool isEnough() const { return int(distances.size()) >= kFewestNodes; }
};

/// Distance along its normal from a node to the measured skin; nullopt where that is turned away or unseen.
std::optional<double> distance_mm(const MeasuredFace& face, const cameras::StereoRig& rig,
                                  const Eigen::Vector3d& p_mm, const Eigen::Vector3d& normal) {
  if (p_mm.z() < 50 || -normal.dot(p_mm.normalized()) < kGrazing_cos) return std::nullopt;
  const auto measured_mm = face.near(cameras::project(rig.left, p_mm));
  if (!measured_mm) return std::nullopt;
  return normal.dot(*measured_mm - p_mm);
}

}  // namespace

FaceShape::FaceShape(const cameras::StereoRig& rig, const FaceRegion& region, const FaceSurface& surface,
                     const SkinMobility& mobility) {
  const cv::Rect box = region.box();
  const double step = std::max(2.0, box.width / kNodesAcross);
  for (double y = box.y; y < box.br().y; y += step)
    for (double x = box.x; x < box.br().x; x += step) {
      const Eigen::Vector2d px(x, y);
      if (!region.contains(px) || mobility.at(px).sigma_mm > SkinMobility::kUpperFace_mm) continue;
      const auto local = surface.around(px, 2 * step);
      if (!local || !(local->inverseDepth(px) > 0)) continue;
      const auto lift = [&](const Eigen::Vector2d& p) -> Eigen::Vector3d {
        return cameras::undistort(rig.left, p).homogeneous() / local->inverseDepth(p);
      };
      const Eigen::Vector3d across = lift({x + step, y}) - lift({x - step, y}),
                            down = lift({x, y + step}) - lift({x, y - step});
      const Node node{lift(px), down.cross(across).normalized(), mobility.at(px).sigma_mm};
      if (node.mm.allFinite() && node.normal.allFinite()) nodes_.push_back(node);
    }
  for (const auto& node : nodes_) centre_mm_ += node.mm / double(nodes_.size());
}

std::optional<Eigen::Isometry3d> FaceShape::fit(const cameras::StereoRig& rig,
                                                const cameras::StereoFrame& frame,
                                                const Eigen::Isometry3d& start) const {
  if (int(nodes_.size()) < kFewestNodes) return std::nullopt;
  FaceBounds bounds;
  for (const auto& node : nodes_) {
    const Eigen::Vector3d p_mm = start * node.mm;
    if (p_mm.z() < kNodeReach_mm) return std::nullopt;
    bounds.add(cameras::project(rig.left, p_mm), p_mm.z());
  }
  const auto face = measureWithin(bounds, rig, frame);
  if (!face) return std::nullopt;
  Eigen::Isometry3d camera_T_head = start;
  double scale = 3.0;
  for (int iteration = 0; iteration < kShapeSteps; ++iteration) {
    const Eigen::Matrix3d& turn = camera_T_head.linear();
    ShapeStep step;
    for (const auto& node : nodes_) {
      const Eigen::Vector3d p_mm = camera_T_head * node.mm, normal = turn * node.normal;
      const auto off_mm = distance_mm(*face, rig, p_mm, normal);
      if (!off_mm || std::abs(*off_mm) > kFarthest_mm * std::max(1.0, scale)) continue;
      Vector6d j;
      j << (node.mm - centre_mm_).cross(node.normal), node.normal;
      step.add(*off_mm, node.mobility_mm, scale, j);
    }
    if (!step.isEnough()) return std::nullopt;
    const Vector6d xi = solveSymmetric(step.h, step.g);
    if (!xi.allFinite()) return std::nullopt;
    camera_T_head =
        camera_T_head * Eigen::Translation3d(centre_mm_) * expRigid(xi) * Eigen::Translation3d(-centre_mm_);
    scale = std::max(0.7, kSigmaPerMad * upperMedian(step.distances));
    if (xi.tail<3>().norm() + 60.0 * xi.head<3>().norm() < kSettled_mm) break;
  }
  return camera_T_head;
}

}  // namespace facenav::head_tracking
