#include "facenav/monitoring/drift_check.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav::monitoring {
namespace {

constexpr int kCell_px = 4;  // cell of the map of the reference's skin
// Largest distance of a point from the skin; a hand, hair or the wall is further away.
constexpr double kReach_mm = 12.0;
// Disparity error of a point without dots, in addition to its computed standard error.
constexpr double kPointError_px = 0.1;
// Part of that error that the whole face shares. Evidence: resources/doc/evidence.md.
constexpr double kCommonError_px = 0.06;
constexpr std::size_t kMostSamples = 6000;
constexpr std::size_t kFewestSamples = 400;
constexpr int kTile_px = 32;  // stereo errors within a tile are correlated
constexpr int kIterations = 10;
constexpr double kHalfFace_mm = 70.0;
// Limits of an alarm, without the check's own error: less than half of a wrong pose (3 mm, 2 degrees).
constexpr double kTolerated_mm = 1.2, kTolerated_deg = 0.8;
// Largest movement of a head at rest between the alignment's picture and the reference; about the alignment's
// own error. Evidence: resources/doc/evidence.md.
constexpr double kStill_mm = 0.5, kStill_deg = 0.3;

/// Sums of the normal equations, and each image tile's part of the gradient.
struct Normal {
  Matrix6d h = Matrix6d::Zero();
  Vector6d g = Vector6d::Zero();
  std::map<std::pair<int, int>, Vector6d> pulls;
  std::vector<double> distances;  // |residual| in standard deviations
  int used = 0;

  /// Sandwich covariance, valid for errors that are correlated within a tile (Liang & Zeger 1986).
  Matrix6d covariance() const {
    Matrix6d pull = Matrix6d::Zero();
    for (const auto& tile : pulls) pull += tile.second * tile.second.transpose();
    const Matrix6d inverse = inverseOf(h);
    const double count = double(pulls.size());
    return count / std::max(1.0, count - 6.0) * inverse * pull * inverse;
  }
};

/// Robust standard deviation, from the smallest third of the absolute values, because more than half of the
/// face may be occluded.
double spreadOf(std::vector<double>& lengths) {
  constexpr double kShare = 0.35, kQuantile = 0.4538;  // P(|x| < 0.4538) = 0.35
  return selectRank(lengths, std::size_t(kShare * double(lengths.size()))) / kQuantile;
}

DriftFinding::Verdict verdictOn(const DriftFinding& f, double tolerated_mm, double tolerated_deg) {
  if (f.shift_mm > tolerated_mm + kSignificant * f.shift_sigma_mm ||
      f.turn_deg > tolerated_deg + kSignificant * f.turn_sigma_deg)
    return DriftFinding::Verdict::drifted;
  const bool is_sharp = f.shift_sigma_mm < kTolerated_mm && f.turn_sigma_deg < kTolerated_deg;
  return is_sharp ? DriftFinding::Verdict::agrees : DriftFinding::Verdict::unknown;
}

}  // namespace

double DriftCheck::depthPerPixel_mm(double depth_mm) const {
  return depth_mm * depth_mm / (rig_.left.k(0, 0) * rig_.baseline_mm());
}

std::optional<float> DriftCheck::SkinMap::at(const Eigen::Vector2d& px) const {
  const int x = int(std::floor(px.x() / kCell_px)), y = int(std::floor(px.y() / kCell_px));
  if (!(px.x() >= 0 && px.y() >= 0) || x >= columns || y >= rows) return std::nullopt;
  const float misfit = misfit_mm[std::size_t(y) * std::size_t(columns) + std::size_t(x)];
  if (std::isnan(misfit)) return std::nullopt;
  return misfit;
}

DriftCheck::DriftCheck(const cameras::StereoRig& rig, std::shared_ptr<const registration::ScalpField> scalp,
                       const head_tracking::HeadReference& reference,
                       const RigidTransform<Camera, Mri>& camera_T_mri)
    : rig_(rig),
      right_T_left_(rig.right_T_left),
      scalp_(std::move(scalp)),
      mri_T_head_(camera_T_mri.isometry().inverse()) {
  FACENAV_EXPECT(scalp_ != nullptr, "a scalp is needed");
  skin_.columns = rig.width_px / kCell_px + 1, skin_.rows = rig.height_px / kCell_px + 1;
  std::vector<std::pair<double, int>> sums(std::size_t(skin_.columns) * std::size_t(skin_.rows));
  const auto& points = reference.surface.points_mm;
  const std::size_t step = std::max<std::size_t>(1, points.size() / 2000);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& px = reference.surface_left_px[i];
    const auto skin = scalp_->fine((mri_T_head_ * points[i]).cast<float>());
    if (!(std::abs(skin.distance_mm) < float(kReach_mm))) continue;
    auto& cell = sums.at(std::size_t(int(px.y()) / kCell_px) * std::size_t(skin_.columns) +
                         std::size_t(int(px.x()) / kCell_px));
    cell.first += skin.distance_mm, ++cell.second;
    if (i % step == 0) surface_mm_.push_back(points[i]);
  }
  for (const auto& [sum, count] : sums)
    skin_.misfit_mm.push_back(count > 0 ? float(sum / count) : std::numeric_limits<float>::quiet_NaN());
  for (const auto& p : surface_mm_) centre_mm_ += p / double(surface_mm_.size());
  const auto at_reference =
      offsetOf(measureSkin(reference.frame, Eigen::Isometry3d::Identity()), Eigen::Isometry3d::Identity());
  if (!at_reference) return;
  at_reference_ = findingOf(*at_reference, Vector6d::Zero(), Eigen::Isometry3d::Identity());
  at_reference_.verdict = verdictOn(at_reference_, kStill_mm, kStill_deg);
  bias_ = at_reference->xi;
}

std::vector<DriftCheck::Sample> DriftCheck::measureSkin(const cameras::StereoFrame& frame,
                                                        const Eigen::Isometry3d& motion) const {
  std::vector<Sample> samples;
  stereo::FaceCloudOptions options;
  options.match = stereo::quickSkinOptions();
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  double nearest_mm = 1e9, farthest_mm = 0;
  for (const auto& p_head_mm : surface_mm_) {
    const Eigen::Vector3d p_mm = motion * p_head_mm;
    if (p_mm.z() < 50) return samples;
    const Eigen::Vector2d px = cameras::project(rig_.left, p_mm);
    low = low.cwiseMin(px), high = high.cwiseMax(px);
    nearest_mm = std::min(nearest_mm, p_mm.z()), farthest_mm = std::max(farthest_mm, p_mm.z());
  }
  if (surface_mm_.empty() || !((high - low).maxCoeff() < 1e5)) return samples;
  const cv::Rect box =
      cv::Rect(cv::Point(int(low.x()), int(low.y())), cv::Point(int(high.x()), int(high.y()))) &
      cv::Rect(0, 0, rig_.width_px, rig_.height_px);
  if (box.width < 40 || box.height < 40) return samples;
  options.left_roi = box;
  options.nearest_mm = std::max(50.0, nearest_mm - kDepthMargin_mm);
  options.farthest_mm = farthest_mm + kDepthMargin_mm;
  stereo::FaceCloud face;
  try {
    TaskMonitor monitor;
    face = stereo::measureFace(rigNow(), frame, options, monitor);
  } catch (const Error&) {  // too little texture or too dark: no result
    return samples;
  }
  const std::size_t step = std::max<std::size_t>(1, face.cloud.size() / kMostSamples);
  for (std::size_t i = 0; i < face.cloud.size(); i += step) {
    const Eigen::Vector3d at_reference_mm = motion.inverse() * face.cloud.points_mm[i];
    if (at_reference_mm.z() < 50) continue;
    const auto misfit_mm = skin_.at(cameras::project(rig_.left, at_reference_mm));
    if (!misfit_mm) continue;
    samples.push_back({face.cloud.points_mm[i], face.left_px[i], *misfit_mm,
                       std::hypot(double(face.sigma_mm[i]),
                                  kPointError_px * depthPerPixel_mm(face.cloud.points_mm[i].z()))});
  }
  return samples;
}

std::optional<DriftCheck::Offset> DriftCheck::offsetOf(const std::vector<Sample>& samples,
                                                       const Eigen::Isometry3d& motion) const {
  if (samples.size() < kFewestSamples) return std::nullopt;
  const Eigen::Isometry3d head_T_camera = motion.inverse();
  Eigen::Isometry3d corrected = Eigen::Isometry3d::Identity();  // Head
  const Eigen::Vector3d eye_mm = head_T_camera.translation();
  Normal sums;
  double scale = 3.0;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    sums = {};
    for (const auto& sample : samples) {
      const Eigen::Vector3d p_mm = corrected * (head_T_camera * sample.p_mm);
      const auto skin = scalp_->fine((mri_T_head_ * p_mm).cast<float>());
      if (!(std::abs(skin.distance_mm) < float(kReach_mm))) continue;
      const Eigen::Vector3d outward = mri_T_head_.linear().transpose() * skin.gradient.cast<double>();
      if (outward.dot(eye_mm - p_mm) < kObliqueSkin_cos * (eye_mm - p_mm).norm()) continue;
      const double off_mm = double(skin.distance_mm) - sample.misfit_mm;
      const double distance = off_mm / sample.sigma_mm;
      sums.distances.push_back(std::abs(distance));
      const double q = std::pow(distance / (kTukeyReach * scale), 2);
      if (q >= 1) continue;
      const double weight = (1 - q) * (1 - q) / (sample.sigma_mm * sample.sigma_mm);
      Vector6d j;
      j << (p_mm - centre_mm_).cross(outward), outward;
      const Vector6d pull = -weight * off_mm * j;
      sums.h.noalias() += weight * j * j.transpose();
      sums.g += pull;
      const auto tile = std::pair(int(sample.left_px.x()) / kTile_px, int(sample.left_px.y()) / kTile_px);
      sums.pulls.try_emplace(tile, Vector6d::Zero()).first->second += pull;
      ++sums.used;
    }
    if (sums.used < int(kFewestSamples)) return std::nullopt;
    const Vector6d xi = solveSymmetric(sums.h, sums.g);
    if (!xi.allFinite()) return std::nullopt;
    corrected =
        Eigen::Translation3d(centre_mm_) * expRigid(xi) * Eigen::Translation3d(-centre_mm_) * corrected;
    scale = std::max(0.7, spreadOf(sums.distances));
  }
  Offset offset;
  offset.xi << logRotation(corrected.linear()), corrected * centre_mm_ - centre_mm_;
  offset.covariance = sums.covariance();
  offset.points = sums.used;
  return offset;
}

void DriftCheck::moveRight(const RigidTransform<RightCamera, Camera>& right_T_left) {
  const std::lock_guard lock(moving_);
  right_T_left_ = right_T_left;
}

cameras::StereoRig DriftCheck::rigNow() const {
  cameras::StereoRig rig = rig_;
  const std::lock_guard lock(moving_);
  rig.right_T_left = right_T_left_;
  return rig;
}

DriftFinding DriftCheck::findingOf(const Offset& offset, const Vector6d& bias,
                                   const Eigen::Isometry3d& motion) const {
  DriftFinding finding;
  const Vector6d drift = offset.xi - bias;
  finding.points = offset.points;
  finding.shift_mm = drift.tail<3>().norm();
  finding.turn_deg = drift.head<3>().norm() / kRadPerDeg;
  const double common_mm = kCommonError_px * depthPerPixel_mm((motion * centre_mm_).z());
  finding.shift_sigma_mm =
      std::hypot(std::sqrt(offset.covariance.bottomRightCorner<3, 3>().trace()), common_mm);
  finding.turn_sigma_deg =
      std::hypot(std::sqrt(offset.covariance.topLeftCorner<3, 3>().trace()), common_mm / kHalfFace_mm) /
      kRadPerDeg;
  finding.verdict = verdictOn(finding, kTolerated_mm, kTolerated_deg);
  return finding;
}

DriftFinding DriftCheck::measure(const cameras::StereoFrame& frame,
                                 const RigidTransform<Camera, Mri>& camera_T_mri) const {
  const Eigen::Isometry3d motion = camera_T_mri.isometry() * mri_T_head_;  // = camera_T_head
  const auto offset = offsetOf(measureSkin(frame, motion), motion);
  return offset ? findingOf(*offset, bias_, motion) : DriftFinding();
}

}  // namespace facenav::monitoring
