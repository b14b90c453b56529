#include "feature_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rigid_fit.h"
#include "facenav/geometry/rotation.h"

namespace facenav::peers {
namespace {

constexpr std::size_t kLeastFeatures = 5;
constexpr double kEpipolar_px = 2.0;     // largest epipolar error of a match
constexpr double kMatchSigma_px = 0.35;  // of one coordinate of an NCC peak on a rotating face
constexpr double kFarthest_sigma = 4.0;
constexpr double kHighestRms_px = 1.2;
constexpr double kLeastAgreeing = 4.0;  // sum of the weights after the fit
constexpr double kWorstSigma_rad = 1.2 * kRadPerDeg;

struct Triangulated {
  FeatureMatch match;
  Eigen::Vector3d now_mm;
};

std::vector<Triangulated> triangulateMatches(const cameras::StereoRig& rig,
                                             const std::vector<FeatureMatch>& matches) {
  std::vector<Triangulated> points;
  for (const auto& match : matches) {
    if (cameras::epipolarError_px(rig, match.left_px, match.right_px) > kEpipolar_px) continue;
    const Eigen::Vector3d now_mm = cameras::triangulate(rig, match.left_px, match.right_px).mm;
    if (now_mm.z() > 0) points.push_back({match, now_mm});
  }
  return points;
}

// Standard deviation of a triangulated point along the ray, and across it.
double depthSigma(const cameras::StereoRig& rig, double z_mm) {
  return std::sqrt(2.0) * kMatchSigma_px * z_mm * z_mm / (rig.left.k(0, 0) * rig.baseline_mm());
}

bool areRigid(const std::vector<Eigen::Vector3d>& from, const std::vector<Eigen::Vector3d>& to,
              double tolerance_mm) {
  for (std::size_t i = 0; i < from.size(); ++i)
    for (std::size_t j = i + 1; j < from.size(); ++j)
      if (std::abs((from[i] - from[j]).norm() - (to[i] - to[j]).norm()) > tolerance_mm) return false;
  return true;
}

// Section 4, equation 2: the motion (R, t) that minimises the weighted distances of the pairs, in closed
// form.
Eigen::Isometry3d fit(const std::vector<Eigen::Vector3d>& reference_mm,
                      const std::vector<Triangulated>& points) {
  std::vector<Eigen::Vector3d> from, to;
  std::vector<double> weights;
  for (const auto& point : points) {
    from.push_back(reference_mm[point.match.feature]);
    to.push_back(point.now_mm);
    weights.push_back(point.match.weight);
  }
  return fitRigidPoints(from, to, weights).to_T_from;
}

// The largest set of points that one motion explains; each triple of points proposes a motion.
std::vector<Triangulated> consensus(const cameras::StereoRig& rig,
                                    const std::vector<Eigen::Vector3d>& reference_mm,
                                    const std::vector<Triangulated>& points) {
  std::vector<Triangulated> best;
  double best_error = 0;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b)
      for (std::size_t c = b + 1; c < points.size(); ++c) {
        const double tolerance_mm = kFarthest_sigma * depthSigma(rig, points[a].now_mm.z());
        const auto ref = [&](std::size_t i) { return reference_mm[points[i].match.feature]; };
        if ((ref(b) - ref(a)).cross(ref(c) - ref(a)).norm() < 100.0) continue;  // mm2: too thin a triangle
        if (!areRigid({ref(a), ref(b), ref(c)}, {points[a].now_mm, points[b].now_mm, points[c].now_mm},
                      tolerance_mm))
          continue;
        const auto motion = fit(reference_mm, {points[a], points[b], points[c]});
        std::vector<Triangulated> agreeing;
        double error = 0;
        for (const auto& point : points) {
          const double distance_mm = (motion * reference_mm[point.match.feature] - point.now_mm).norm();
          if (distance_mm > tolerance_mm) continue;
          agreeing.push_back(point);
          error += distance_mm;
        }
        if (agreeing.size() > best.size() || (agreeing.size() == best.size() && error < best_error))
          best = agreeing, best_error = error;
      }
  return best;
}

struct Normal {
  Matrix6d h = Matrix6d::Zero();
  Vector6d g = Vector6d::Zero();
  double squares = 0.0, weight = 0.0;
};

void accumulate(const cameras::CameraModel& camera, const Eigen::Matrix3d& rotation,
                const Eigen::Vector3d& p_mm, const Eigen::Vector3d& arm_mm, const Eigen::Vector2d& seen_px,
                double weight, Normal& normal) {
  Eigen::Matrix<double, 2, 3> d_p;
  const Eigen::Vector2d residual = seen_px - cameras::project(camera, p_mm, d_p);
  Eigen::Matrix<double, 2, 6> j;
  j << d_p * rotation * -skew(arm_mm), d_p * rotation;
  normal.h += weight * j.transpose() * j;
  normal.g += weight * j.transpose() * residual;
  normal.squares += weight * residual.squaredNorm();
  normal.weight += 2 * weight;
}

// Weighted squared reprojection errors in both images, linearised at `fit.motion` about its centre.
Normal linearise(const cameras::StereoRig& rig, const std::vector<Eigen::Vector3d>& reference_mm,
                 const FeatureFit& fit) {
  Normal normal;
  const Eigen::Isometry3d right_T_left = rig.right_T_left.isometry();
  for (const auto& match : fit.inliers) {
    const Eigen::Vector3d p_mm = fit.motion * reference_mm[match.feature], arm_mm = p_mm - fit.centre_mm;
    accumulate(rig.left, Eigen::Matrix3d::Identity(), p_mm, arm_mm, match.left_px, match.weight, normal);
    accumulate(rig.right, right_T_left.linear(), right_T_left * p_mm, arm_mm, match.right_px, match.weight,
               normal);
  }
  return normal;
}

// Squared reprojection error of a feature, mean of both images.
double square_px(const cameras::StereoRig& rig, const Eigen::Vector3d& p_mm, const FeatureMatch& match) {
  const Eigen::Vector3d p_right_mm = rig.right_T_left.isometry() * p_mm;
  return 0.5 * ((match.left_px - cameras::project(rig.left, p_mm)).squaredNorm() +
                (match.right_px - cameras::project(rig.right, p_right_mm)).squaredNorm());
}

// Cauchy weights on whole features. The error of one feature (the nose tip's template slides over the round
// nose as the head turns; a lid; a lip) must not bend the pose of the others.
void reweigh(const cameras::StereoRig& rig, const std::vector<Eigen::Vector3d>& reference_mm,
             const std::vector<double>& ncc, FeatureFit& fit) {
  std::vector<double> lengths;
  for (const auto& match : fit.inliers)
    lengths.push_back(std::sqrt(square_px(rig, fit.motion * reference_mm[match.feature], match)));
  const double scale = std::max(std::sqrt(2.0) * kMatchSigma_px, 1.2 * upperMedian(lengths));
  for (std::size_t i = 0; i < lengths.size(); ++i)
    fit.inliers[i].weight = ncc[i] / (1.0 + std::pow(lengths[i] / scale, 4));
}

// Gauss-Newton from the closed-form pose, reweighted in each round.
void refineInImages(const cameras::StereoRig& rig, const std::vector<Eigen::Vector3d>& reference_mm,
                    FeatureFit& fit) {
  const Eigen::Vector3d reference_centre_mm = fit.motion.inverse() * fit.centre_mm;
  std::vector<double> ncc;
  for (const auto& match : fit.inliers) ncc.push_back(match.weight);
  for (int iteration = 0; iteration < 20; ++iteration) {
    if (iteration > 1) reweigh(rig, reference_mm, ncc, fit);
    const Normal normal = linearise(rig, reference_mm, fit);
    const Vector6d step = solveSymmetric(normal.h, normal.g);
    const Eigen::Isometry3d increment =
        Eigen::Translation3d(fit.centre_mm) * expRigid(step) * Eigen::Translation3d(-fit.centre_mm);
    fit.motion = increment * fit.motion;
    fit.centre_mm = fit.motion * reference_centre_mm;
    if (iteration > 3 && step.tail<3>().norm() < 1e-4 && step.head<3>().norm() < 1e-6) break;
  }
  const Normal normal = linearise(rig, reference_mm, fit);
  fit.rms_px = std::sqrt(normal.squares / normal.weight);
  // Low weights reduce the degrees of freedom. A peak is never better than kMatchSigma_px.
  double features = 0;
  for (std::size_t i = 0; i < ncc.size(); ++i) features += fit.inliers[i].weight / ncc[i];
  const double spare = std::max(4.0 * features - 6.0, 2.0);
  const double mean_weight = normal.weight / (4.0 * features);
  fit.covariance = mean_weight *
                   std::max(normal.squares / mean_weight / spare, kMatchSigma_px * kMatchSigma_px) *
                   inverseOf(normal.h);
}

}  // namespace

Tracked<FeatureFit> fitFeatures(const cameras::StereoRig& rig,
                                const std::vector<Eigen::Vector3d>& reference_mm,
                                const std::vector<FeatureMatch>& matches) {
  if (matches.size() < kLeastFeatures) return Lost{LostReason::few_features};
  const auto points = triangulateMatches(rig, matches);
  if (points.size() < kLeastFeatures) return Lost{LostReason::high_residual};
  const auto agreeing = consensus(rig, reference_mm, points);
  if (agreeing.size() < kLeastFeatures) return Lost{LostReason::high_residual};
  FeatureFit result;
  result.motion = fit(reference_mm, agreeing);
  for (const auto& point : agreeing) {
    result.inliers.push_back(point.match);
    result.centre_mm += result.motion * reference_mm[point.match.feature] / double(agreeing.size());
  }
  refineInImages(rig, reference_mm, result);
  double agreeing_features = 0;  // sum of the weights after the fit
  for (const auto& match : result.inliers) agreeing_features += match.weight;
  const double sigma_rad = std::sqrt(result.covariance.topLeftCorner<3, 3>().trace());
  if (!(result.rms_px < kHighestRms_px) || agreeing_features < kLeastAgreeing ||
      !(sigma_rad < kWorstSigma_rad))
    return Lost{LostReason::high_residual};
  double quality = 0;
  for (const auto& match : result.inliers) quality += match.weight / double(reference_mm.size());
  return {result, std::clamp(quality, 0.0, 1.0)};
}

}  // namespace facenav::peers
