#include "recovery_pose.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"
#include "facenav/head_tracking/skin_field_model.h"
#include "skin_field.h"

namespace facenav::head_tracking {
namespace {

constexpr int kFewestMatches = 24;
constexpr double kRig_rad = 0.15 * kRadPerDeg,
                 kRig_mm = 0.3;  // errors of each camera's own pose from rig and lens
// Coarse to fine: each level is searched until it has settled.
constexpr SkinSearch kSearches[] = {{2, 8, 2}, {2, 4, 2}, {1, 5, 2}, {1, 4, 2}, {0, 4, 1}, {0, 6, 1}};

struct Solution {
  Vector6d xi = Vector6d::Zero();
  Matrix6d information = Matrix6d::Zero();
  double scale = 1.0;
  std::vector<double> weight;
  std::vector<Eigen::Vector2d> residual;  // px, per match
};

Solution solve(const std::vector<SkinMatch>& matches, const std::vector<Eigen::Matrix2d>& precision) {
  Solution s;
  s.weight.assign(matches.size(), 1.0);
  s.residual.resize(matches.size());
  std::vector<double> distance(matches.size());
  const double least_scale = settingsOf<SkinFieldModel>().field_least_scale;
  for (int round = 0; round < kReweightings; ++round) {
    Matrix6d h = Matrix6d::Identity() * 1e-9;
    Vector6d g = Vector6d::Zero();
    for (std::size_t i = 0; i < matches.size(); ++i) {
      const Eigen::Matrix<double, 6, 2> weighted =
          s.weight[i] * matches[i].jacobian.transpose() * precision[i];
      h.noalias() += weighted * matches[i].jacobian;
      g.noalias() += weighted * matches[i].offset_px;
    }
    const Vector6d before = s.xi;
    s.xi = solveSymmetric(h, g), s.information = h;
    if (!s.xi.allFinite()) return {};
    for (std::size_t i = 0; i < matches.size(); ++i) {
      s.residual[i] = matches[i].offset_px - matches[i].jacobian * s.xi;
      distance[i] = std::sqrt(std::max(0.0, s.residual[i].dot(precision[i] * s.residual[i])));
    }
    s.scale = std::max(least_scale, upperMedian(distance) / kMedianLength);
    for (std::size_t i = 0; i < matches.size(); ++i)
      s.weight[i] = (kStudentFreedom + 2) / (kStudentFreedom + std::pow(distance[i] / s.scale, 2));
    if (round > 2 && (s.xi - before).norm() < 1e-6) break;
  }
  return s;
}

// Covariance including errors that are shared within a part of the face, as shown by the change of the pose
// when a part is left out (delete-one jackknife over clusters; Bell & McCaffrey 2002, CR3). The weights are
// kept.
Matrix6d covarianceOf(const SkinPoints& points, const std::vector<SkinMatch>& matches,
                      const std::vector<Eigen::Matrix2d>& precision, const Solution& s) {
  struct Part {
    Matrix6d information = Matrix6d::Zero();
    Vector6d pull = Vector6d::Zero();
    int matches = 0;
  };
  std::vector<Part> parts(std::size_t(points.regionCount()));
  for (std::size_t i = 0; i < matches.size(); ++i) {
    Part& part = parts[std::size_t(points[std::size_t(matches[i].point)].region)];
    const Eigen::Matrix<double, 6, 2> weighted = s.weight[i] * matches[i].jacobian.transpose() * precision[i];
    part.information.noalias() += weighted * matches[i].jacobian;
    part.pull.noalias() += weighted * s.residual[i];
    ++part.matches;
  }
  Matrix6d jackknife = Matrix6d::Zero();
  int clusters = 0;
  for (const auto& part : parts) {
    if (part.matches == 0) continue;
    const Vector6d change = solveSymmetric(s.information - part.information, part.pull);
    if (!change.allFinite()) return Matrix6d::Identity() * 1e6;
    jackknife += change * change.transpose();
    ++clusters;
  }
  const double spread = std::max(1.0, s.scale * s.scale);
  return spread * inverseOf(s.information) + (clusters - 1.0) / std::max(1, clusters) * jackknife;
}

std::vector<Eigen::Matrix2d> precisionOf(const SkinPoints& points, const std::vector<SkinMatch>& matches) {
  std::vector<Eigen::Matrix2d> precision;
  for (const auto& match : matches)
    precision.push_back(errorOf(match, points[std::size_t(match.point)].mobility_mm).inverse());
  return precision;
}

// Pose of each camera alone, from the matches of the joint search.
void compareSides(const SkinPoints& points, const std::vector<SkinMatch>& matches, RecoveryPose& pose) {
  Vector6d xi[2], rig_error;
  rig_error << Eigen::Vector3d::Constant(kRig_rad), Eigen::Vector3d::Constant(kRig_mm);
  Matrix6d covariance = rig_error.cwiseAbs2().asDiagonal();
  for (int c = 0; c < 2; ++c) {
    std::vector<SkinMatch> own;
    for (const auto& match : matches)
      if (match.camera == c && points[std::size_t(match.point)].mobility_mm <= SkinMobility::kUpperFace_mm)
        own.push_back(match);
    if (int(own.size()) < kFewestMatches) return;
    const auto precision = precisionOf(points, own);
    const Solution s = solve(own, precision);
    if (s.weight.empty()) return;
    xi[c] = s.xi;
    covariance += covarianceOf(points, own, precision, s);
  }
  const Vector6d apart = xi[1] - xi[0];
  pose.sides_apart = apart.dot(solveSymmetric(covariance, apart));
}

Eigen::Isometry3d about(const Eigen::Vector3d& centre_mm, const Vector6d& xi) {
  return Eigen::Translation3d(centre_mm) * expRigid(xi) * Eigen::Translation3d(-centre_mm);
}

}  // namespace

RecoveryPose fitRecoveryPose(const cameras::StereoRig& rig, const SkinPoints& points, const SkinView& then,
                             const RecoveryPictures& now, const Eigen::Isometry3d& start, Sides sides) {
  RecoveryPose pose;
  pose.camera_T_head = start;
  for (const auto& search : kSearches) {
    auto matches = points.find(then, rig, now, pose.camera_T_head, search);
    if (sides != Sides::both)
      matches.erase(std::remove_if(matches.begin(), matches.end(),
                                   [&](const auto& m) { return m.camera != (sides == Sides::left ? 0 : 1); }),
                    matches.end());
    if (int(matches.size()) < kFewestMatches) return pose;
    const auto precision = precisionOf(points, matches);
    const Solution s = solve(matches, precision);
    if (s.weight.empty()) return pose;
    const bool is_last = &search == std::end(kSearches) - 1;
    const auto field = search.level == 0 ? solveWithSkinField(points, matches) : std::nullopt;
    if (is_last && !field) return pose;
    pose.camera_T_head = pose.camera_T_head * about(points.centre_mm(), field ? field->xi : s.xi);
    if (!is_last) continue;
    Matrix6d rotate = Matrix6d::Zero();  // from Head's axes to Camera's
    rotate.topLeftCorner<3, 3>() = rotate.bottomRightCorner<3, 3>() = pose.camera_T_head.linear();
    pose.covariance = rotate * field->covariance * rotate.transpose() + then.covariance;
    pose.unseen_covariance =
        settingsOf<SkinFieldModel>().pose_unseen * pose.covariance + then.between_sessions;
    pose.residual_px = field->residual_px;
    compareSides(points, matches, pose);
    pose.matches = std::move(matches);
    pose.is_valid = true;
  }
  return pose;
}

}  // namespace facenav::head_tracking
