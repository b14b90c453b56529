#include "facenav/registration/pose_uncertainty.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "facenav/geometry/normal_equations.h"
#include "facenav/registration/aligner.h"

namespace facenav::registration {

namespace {

Eigen::Matrix3d covarianceAt(const Matrix6d& covariance, const RigidTransform<Camera, Mri>& camera_T_mri,
                             const Point<Mri>& target) {
  const Eigen::Vector3d lever = camera_T_mri.rotation() * target.mm;
  Eigen::Matrix<double, 3, 6> carry;
  carry << -skew(lever), Eigen::Matrix3d::Identity();
  return carry * covariance * carry.transpose();
}

/// Quantile of the standard normal distribution (Abramowitz and Stegun 26.2.23, within 0.0005).
double normalQuantile(double probability) {
  const double t = std::sqrt(-2.0 * std::log(1.0 - probability));
  return t -
         (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
}

/// Quantile of Fisher's F (Paulson 1942), probability above one half.
double fisherQuantile(double probability, double numerator, double denominator) {
  const double a = 2 / (9 * numerator), b = 2 / (9 * denominator), z = normalQuantile(probability);
  const double root = std::sqrt(a * (1 - b) * (1 - b) + b * (1 - a) * (1 - a) - a * b * z * z);
  return std::pow(((1 - a) * (1 - b) + z * root) / ((1 - b) * (1 - b) - b * z * z), 3);
}

}  // namespace

double PoseUncertainty::predictedError_mm(const RigidTransform<Camera, Mri>& camera_T_mri,
                                          const Point<Mri>& target) const {
  return std::sqrt(covarianceAt(covariance, camera_T_mri, target).trace());
}

double PoseUncertainty::errorBound_mm(const RigidTransform<Camera, Mri>& camera_T_mri,
                                      const Point<Mri>& target, double probability) const {
  // The squared length is a weighted sum of chi squares, approximated by one chi square with fewer degrees of
  // freedom (Satterthwaite 1946), divided by the chi square of the t distribution.
  const Eigen::Vector3d variances = principalAxes(covarianceAt(covariance, camera_T_mri, target)).values;
  const double sum = variances.sum();
  if (!(sum > 0)) return 0.0;
  const double directions = std::max(1.0, sum * sum / variances.squaredNorm());
  const double nu = std::max(5.0, freedom);
  return std::sqrt(sum * (nu - 2) / nu * fisherQuantile(std::max(0.5, probability), directions, nu));
}

double AlignmentResult::predictedError_mm(const Point<Mri>& target) const {
  return uncertainty().predictedError_mm(camera_T_mri, target);
}

Eigen::Vector3d TurnableCamera::displacement(const Eigen::Vector3d& p_camera_mm) const {
  const Eigen::Vector3d ray = p_camera_mm.normalized(), swept = axis.v.cross(p_camera_mm - centre.mm);
  return ray * (swept.squaredNorm() / swept.dot(ray));
}

Vector6d motionByTurn(const TurnableCamera& right, const std::vector<Eigen::Vector3d>& points_mm) {
  if (points_mm.empty()) return Vector6d::Zero();
  Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
  for (const auto& p : points_mm) middle_mm += p / double(points_mm.size());
  Matrix6d matrix = Matrix6d::Zero();
  Vector6d by = Vector6d::Zero();
  for (const auto& p : points_mm) {
    Eigen::Matrix<double, 3, 6> moves;
    moves << -skew(p - middle_mm), Eigen::Matrix3d::Identity();
    matrix += moves.transpose() * moves;
    by += moves.transpose() * right.displacement(p);
  }
  Vector6d motion = solveSymmetric(matrix, by);
  motion.tail<3>() -= motion.head<3>().cross(middle_mm);  // about Camera's origin
  return motion;
}

namespace {

/// Displacement of the point by a motion (left increment).
Eigen::Vector3d shiftOf(const Vector6d& motion, const Eigen::Vector3d& p_mm) {
  return motion.head<3>().cross(p_mm) + motion.tail<3>();
}

double boundWith_mm(const AlignmentResult& result, const Eigen::Vector3d& shift_mm, const Point<Mri>& target,
                    double probability) {
  PoseUncertainty all = result.uncertainty();
  all.covariance.bottomRightCorner<3, 3>() += shift_mm * shift_mm.transpose();
  return all.errorBound_mm(result.camera_T_mri, target, probability);
}

}  // namespace

double AlignmentResult::errorBound_mm(const Point<Mri>& target, double probability) const {
  return boundWith_mm(*this, shiftOf(head_by_turn, (camera_T_mri * target).mm), target, probability);
}

Eigen::Vector3d AlignmentResult::coilByTurn_mm(const Point<Mri>& target,
                                               const std::vector<Point<Mri>>& marker) const {
  Vector6d apart = -head_by_turn;
  if (right && right_turn) {
    std::vector<Eigen::Vector3d> corners_mm;
    for (const auto& corner : marker) corners_mm.push_back((camera_T_mri * corner).mm);
    apart += std::hypot(right_turn->rad, right_turn->sigma_rad) * motionByTurn(*right, corners_mm);
  }
  return shiftOf(apart, (camera_T_mri * target).mm);
}

double AlignmentResult::coilErrorBound_mm(const Point<Mri>& target, const std::vector<Point<Mri>>& marker,
                                          double probability) const {
  return boundWith_mm(*this, coilByTurn_mm(target, marker), target, probability);
}

}  // namespace facenav::registration
