#include "pose_fit.h"

#include <cmath>

namespace facenav::registration {
namespace {

constexpr double kGrazing_cos = 0.12;      // skin seen flatter than this is no counterpart
constexpr double kNormalsAgree_cos = 0.3;  // cloud normals are noisy: only gross disagreement counts

/// q -> exp(w) (q - pivot) + pivot + v, applied after `pose`.
Eigen::Isometry3d increment(const Vector6d& xi, const Eigen::Vector3d& pivot, const Eigen::Isometry3d& pose) {
  const Eigen::Isometry3d step = expRigid(xi);
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.linear() = step.linear() * pose.linear();
  moved.translation() = step.linear() * (pose.translation() - pivot) + pivot + step.translation();
  return moved;
}

}  // namespace

double tukeyWeight(double residual, double limit) {
  const double u = residual / limit;
  return std::abs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0.0;
}

PoseFitter::PoseFitter(const SkinField& skin, PointCloud<Camera> cloud, std::optional<double> mirror_x_mm)
    : skin_(skin),
      cloud_(std::move(cloud)),
      mirror_x_mm_(mirror_x_mm),
      pivot_(0.5 * (skin.low() + skin.high())) {
  if (cloud_.normals.size() != cloud_.size()) cloud_.normals.clear();
}

PointMatch PoseFitter::matchOne(std::size_t point, const Eigen::Isometry3d& mri_T_camera,
                                bool is_exact) const {
  PointMatch match;
  match.at_mri_mm = mri_T_camera * cloud_.points_mm[point];
  Eigen::Vector3d query = match.at_mri_mm;
  if (mirror_x_mm_) query.x() = 2 * *mirror_x_mm_ - query.x();
  // Background and what lies beyond the scan's end: a look-up tells.
  constexpr double kFar_mm = 45.0;
  match.residual_mm = skin_.roughDistance_mm(query);
  if (match.residual_mm > kFar_mm) return match;
  const SkinContact contact = is_exact ? skin_.nearestSkin(query) : skin_.nearestVertex(query);
  match.normal_mri = contact.normal;
  if (mirror_x_mm_) match.normal_mri.x() *= -1;
  match.residual_mm = contact.distance_mm;
  match.vertex = contact.vertex;
  const Eigen::Vector3d towards_camera = (mri_T_camera.translation() - match.at_mri_mm).normalized();
  match.is_valid =
      !contact.is_on_border && !contact.is_beyond_scan && match.normal_mri.dot(towards_camera) > kGrazing_cos;
  if (match.is_valid && !cloud_.normals.empty())
    match.is_valid = match.normal_mri.dot(mri_T_camera.linear() * cloud_.normals[point]) > kNormalsAgree_cos;
  return match;
}

std::vector<PointMatch> PoseFitter::match(const Eigen::Isometry3d& mri_T_camera, bool is_exact) const {
  std::vector<PointMatch> matches(cloud_.size());
  for (std::size_t p = 0; p < matches.size(); ++p) matches[p] = matchOne(p, mri_T_camera, is_exact);
  return matches;
}

Eigen::Isometry3d PoseFitter::fit(Eigen::Isometry3d pose, const FitStage& stage) const {
  for (int iteration = 0; iteration < stage.iterations; ++iteration) {
    Matrix6d normal_matrix = Matrix6d::Zero();
    Vector6d gradient = Vector6d::Zero();
    double total = 0;
    for (std::size_t p = 0; p < cloud_.size(); ++p) {
      if (!weights_.empty() && weights_[p] <= 0) continue;
      const PointMatch m = matchOne(p, pose, stage.is_exact);
      if (!m.is_valid) continue;
      double weight = tukeyWeight(m.residual_mm, m.residual_mm > 0 ? stage.outside_mm : stage.inside_mm);
      if (weight <= 0) continue;
      if (!weights_.empty()) weight *= weights_[p];
      Vector6d j;
      j << (m.at_mri_mm - pivot_).cross(m.normal_mri), m.normal_mri;
      normal_matrix.selfadjointView<Eigen::Lower>().rankUpdate(j, weight);
      gradient += weight * m.residual_mm * j;
      total += weight;
    }
    if (total < 20) break;
    // A whiff of damping keeps directions that the surface does not fix (a sphere's rotations) where they
    // are.
    normal_matrix.diagonal().head<3>().array() += 1e-4 * total * 1e3;
    normal_matrix.diagonal().tail<3>().array() += 1e-4 * total;
    const Vector6d xi = -normal_matrix.selfadjointView<Eigen::Lower>().ldlt().solve(gradient);
    if (!xi.allFinite()) break;
    pose = increment(xi, pivot_, pose);
    if (xi.head<3>().norm() < 2e-6 && xi.tail<3>().norm() < 2e-4) break;
  }
  return pose;
}

double PoseFitter::cost(const Eigen::Isometry3d& mri_T_camera, double truncation_mm) const {
  const double limit = truncation_mm * truncation_mm;
  double sum = 0;
  for (std::size_t p = 0; p < cloud_.size(); ++p) {
    const PointMatch m = matchOne(p, mri_T_camera, false);
    const double squared = m.residual_mm * m.residual_mm;
    const double deep = 1.3 * limit;
    if (m.is_valid)
      sum += std::min(squared, m.residual_mm < 0 ? deep : limit);
    else
      sum += m.residual_mm < -2 * truncation_mm ? deep : limit;
  }
  return cloud_.empty() ? limit : sum / double(cloud_.size());
}

}  // namespace facenav::registration
