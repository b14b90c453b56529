#include "relative_pose.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <limits>

#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav::health {
namespace {

constexpr double kBehind = 30.0;  // sigmas counted for a point behind the cameras

using Vector6 = Vector6d;

/// Signed Sampson distance, for any depth.
double sampson(const Eigen::Isometry3d& pose, const RayPair& rays) {
  const Eigen::Matrix3d essential = skew(pose.translation().normalized()) * pose.linear();
  const Eigen::Vector3d l = rays.left.homogeneous(), r = rays.right.homogeneous();
  const Eigen::Vector3d in_right = essential * l, in_left = essential.transpose() * r;
  const double slope = std::sqrt(0.5 * (in_right.head<2>().squaredNorm() + in_left.head<2>().squaredNorm()));
  return r.dot(in_right) / (slope * rays.sigma);
}

bool isInFront(const Eigen::Isometry3d& pose, const RayPair& rays) {
  const Eigen::Vector3d l = pose.linear() * rays.left.homogeneous(), r = rays.right.homogeneous();
  const Eigen::Vector3d& t = pose.translation();  // r * s = l * d + t
  const double ll = l.dot(l), rr = r.dot(r), lr = l.dot(r), lt = l.dot(t), rt = r.dot(t);
  const double determinant = ll * rr - lr * lr;
  return determinant > 0 && (rt * lr - lt * rr) > 0 && (rt * ll - lt * lr) > 0;
}

Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Vector6& step) {
  Eigen::Isometry3d next = pose;
  next.linear() = expRotation(step.head<3>()) * pose.linear();
  next.translation() += step.tail<3>();
  next.translation() *= pose.translation().norm() / next.translation().norm();
  return next;
}

/// Sum of Student's t over the matches; a point behind the cameras counts as an outlier.
double costOf(const Eigen::Isometry3d& pose, const std::vector<RayPair>& rays, const PosePrior* prior,
              const Eigen::Isometry3d& about) {
  double cost = costOf(pose, rays);
  if (prior) {
    const Eigen::Vector3d turn = logRotation(pose.linear() * about.linear().transpose());
    cost += turn.squaredNorm() / std::pow(prior->turn_sigma_rad, 2) +
            (pose.translation() - about.translation()).squaredNorm() / std::pow(prior->shift_sigma_mm, 2);
  }
  return cost;
}

}  // namespace

double epipolarDistance(const Eigen::Isometry3d& right_T_left, const RayPair& rays) {
  if (!isInFront(right_T_left, rays)) return std::numeric_limits<double>::infinity();
  return std::abs(sampson(right_T_left, rays));
}

double signedEpipolarDistance(const Eigen::Isometry3d& right_T_left, const RayPair& rays) {
  return sampson(right_T_left, rays);
}

double costOf(const Eigen::Isometry3d& right_T_left, const std::vector<RayPair>& rays) {
  double cost = 0;
  for (const RayPair& pair : rays) {
    const double z =
        isInFront(right_T_left, pair) ? std::min(kBehind, std::abs(sampson(right_T_left, pair))) : kBehind;
    cost += (kStudentFreedom + 1) * std::log1p(z * z / kStudentFreedom);
  }
  return cost;
}

RelativePose refinePose(const Eigen::Isometry3d& start, const std::vector<RayPair>& rays,
                        const PosePrior* prior) {
  const double baseline_mm = start.translation().norm();
  RelativePose best{start, costOf(start, rays, prior, start)};
  double damping = 1e-3;
  for (int round = 0; round < kMostReweightings; ++round) {
    Matrix6d normal = Matrix6d::Zero();
    Vector6 rhs = Vector6::Zero();
    std::array<Eigen::Isometry3d, 6> nudged;
    const auto unit = [&](int k) { return k < 3 ? 1e-6 : 1e-6 * baseline_mm; };
    for (int k = 0; k < 6; ++k) nudged[k] = moved(best.right_T_left, unit(k) * Vector6::Unit(k));
    for (const RayPair& pair : rays) {
      const double z = sampson(best.right_T_left, pair);
      const double weight = (kStudentFreedom + 1) / (kStudentFreedom + z * z);
      Vector6 gradient;
      for (int k = 0; k < 6; ++k) gradient[k] = (sampson(nudged[k], pair) - z) / unit(k);
      normal += weight * gradient * gradient.transpose();
      rhs -= weight * z * gradient;
    }
    Vector6 loose;  // no residual depends on the baseline's length; moved() keeps it
    loose << 1e-2, 1e-2, 1e-2, Eigen::Vector3d::Constant(1e-2 / (baseline_mm * baseline_mm));
    normal.diagonal() += loose;
    if (prior) {
      const Eigen::Vector3d turn = logRotation(best.right_T_left.linear() * start.linear().transpose());
      const double turn_weight = std::pow(prior->turn_sigma_rad, -2),
                   shift_weight = std::pow(prior->shift_sigma_mm, -2);
      normal.diagonal().head<3>().array() += turn_weight;
      normal.diagonal().tail<3>().array() += shift_weight;
      rhs.head<3>() -= turn_weight * turn;
      rhs.tail<3>() -= shift_weight * (best.right_T_left.translation() - start.translation());
    }
    bool is_better = false;
    for (int half = 0; half < 8 && !is_better; ++half, damping *= 4) {
      Matrix6d damped = normal;
      damped.diagonal() *= 1 + damping;
      const Eigen::Isometry3d next = moved(best.right_T_left, solveSymmetric(damped, rhs));
      const double cost = costOf(next, rays, prior, start);
      if (!(cost < best.cost)) continue;
      is_better = best.cost - cost > 1e-3;
      best = {next, cost};
      damping = std::max(1e-9, damping * 0.02);
      if (!is_better) return best;
    }
    if (!is_better) break;
  }
  return best;
}

}  // namespace facenav::health
