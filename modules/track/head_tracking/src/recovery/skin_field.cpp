#include "skin_field.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/head_tracking/skin_field_model.h"

namespace facenav::head_tracking {
namespace {

constexpr double kNoPrior = 1e-9;  // weak prior of the head's motion

// Influence of the nodes on each point's skin (rows: points; unit length). A node has three unknowns.
Eigen::MatrixXd shares(const SkinPoints& points, const std::vector<SkinMatch>& matches) {
  const SkinFieldModel& model = settingsOf<SkinFieldModel>();
  const double spacing_mm = model.field_spacing_mm;
  Eigen::Array2d low = Eigen::Array2d::Constant(1e9), high = -low;
  for (const auto& match : matches) {
    const Eigen::Array2d at = points[std::size_t(match.point)].mm.head<2>().array();
    low = low.min(at), high = high.max(at);
  }
  std::vector<Eigen::Vector2d> nodes;
  for (double x = low.x() - spacing_mm / 2; x < high.x() + spacing_mm; x += spacing_mm)
    for (double y = low.y() - spacing_mm / 2; y < high.y() + spacing_mm; y += spacing_mm)
      nodes.emplace_back(x, y);
  Eigen::MatrixXd share(Eigen::Index(matches.size()), Eigen::Index(nodes.size()));
  for (Eigen::Index i = 0; i < share.rows(); ++i)
    for (Eigen::Index k = 0; k < share.cols(); ++k)
      share(i, k) =
          std::exp(-(points[std::size_t(matches[std::size_t(i)].point)].mm.head<2>() - nodes[std::size_t(k)])
                        .squaredNorm() /
                   (spacing_mm * spacing_mm));
  Eigen::Index used = 0;
  for (Eigen::Index k = 0; k < share.cols(); ++k)
    if (share.col(k).maxCoeff() > model.field_least_reach) share.col(used++) = share.col(k).eval();
  share.conservativeResize(Eigen::NoChange, used);
  share.rowwise().normalize();
  return share;
}

// Rows: two per match. Columns: xi, then three per node, in standard deviations of the prior.
Eigen::MatrixXd designOf(const SkinPoints& points, const std::vector<SkinMatch>& matches) {
  const Eigen::MatrixXd share = shares(points, matches);
  const double shared_part = settingsOf<SkinFieldModel>().field_shared_part;
  Eigen::MatrixXd design(2 * share.rows(), 6 + 3 * share.cols());
  for (Eigen::Index i = 0; i < share.rows(); ++i) {
    const SkinMatch& match = matches[std::size_t(i)];
    const double moved_mm = shared_part * points[std::size_t(match.point)].mobility_mm;
    design.block<2, 6>(2 * i, 0) = match.jacobian;
    for (Eigen::Index k = 0; k < share.cols(); ++k)
      design.block<2, 3>(2 * i, 6 + 3 * k) = moved_mm * share(i, k) * match.jacobian.rightCols<3>();
  }
  return design;
}

struct Observations {
  Eigen::MatrixXd design;
  Eigen::VectorXd offset_px;               // two per match
  std::vector<Eigen::Matrix2d> precision;  // per match

  Eigen::Index count() const { return Eigen::Index(precision.size()); }
};

Observations observationsOf(const SkinPoints& points, const std::vector<SkinMatch>& matches) {
  Observations seen{designOf(points, matches), Eigen::VectorXd(2 * Eigen::Index(matches.size())), {}};
  for (const auto& match : matches) {
    seen.offset_px.segment<2>(2 * seen.count()) = match.offset_px;
    seen.precision.push_back(errorOf(match, points[std::size_t(match.point)].mobility_mm).inverse());
  }
  return seen;
}

// Cauchy weights of the matches from their residuals, in units of the errors of this frame.
std::vector<double> weightsOf(const Observations& seen, const Eigen::VectorXd& residual_px) {
  const SkinFieldModel& model = settingsOf<SkinFieldModel>();
  const double freedom = model.field_freedom;
  std::vector<double> distance, weight;
  for (Eigen::Index i = 0; i < seen.count(); ++i) {
    const Eigen::Vector2d r = residual_px.segment<2>(2 * i);
    distance.push_back(std::sqrt(std::max(0.0, r.dot(seen.precision[std::size_t(i)] * r))));
  }
  const double scale = std::max(model.field_least_scale, upperMedian(distance) / kMedianLength);
  for (const double d : distance) weight.push_back((freedom + 2) / (freedom + std::pow(d / scale, 2)));
  return weight;
}

// Prior weights of the nodes from their found motion. Most of the skin stays and part of it moves far,
// therefore each node's prior is Student's t too.
Eigen::VectorXd priorOf(const Eigen::VectorXd& found) {
  const double freedom = settingsOf<SkinFieldModel>().field_freedom;
  Eigen::VectorXd prior = Eigen::VectorXd::Constant(found.size(), kNoPrior);
  for (Eigen::Index k = 6; k < found.size(); k += 3)
    prior.segment<3>(k).setConstant((freedom + 3) / (freedom + found.segment<3>(k).squaredNorm()));
  return prior;
}

}  // namespace

std::optional<SkinFieldPose> solveWithSkinField(const SkinPoints& points,
                                                const std::vector<SkinMatch>& matches) {
  if (matches.empty()) return std::nullopt;
  const Observations seen = observationsOf(points, matches);
  std::vector<double> weight(matches.size(), 1.0);
  Eigen::VectorXd found = Eigen::VectorXd::Zero(seen.design.cols());
  Eigen::VectorXd residual_px = seen.offset_px;
  Eigen::MatrixXd weighted(seen.design.rows(), seen.design.cols());
  SkinFieldPose pose;
  for (int round = 0; round < kReweightings; ++round) {
    for (Eigen::Index i = 0; i < seen.count(); ++i)
      weighted.middleRows<2>(2 * i).noalias() =
          weight[std::size_t(i)] * seen.precision[std::size_t(i)] * seen.design.middleRows<2>(2 * i);
    Eigen::MatrixXd normal = seen.design.transpose() * weighted;
    normal.diagonal() += priorOf(found);
    const auto factor = normal.ldlt();
    found = factor.solve(weighted.transpose() * seen.offset_px);
    if (!found.allFinite()) return std::nullopt;
    residual_px = seen.offset_px - seen.design * found;
    weight = weightsOf(seen, residual_px);
    if (round == kReweightings - 1)
      pose.covariance = factor.solve(Eigen::MatrixXd::Identity(normal.rows(), 6)).topRows<6>();
  }
  pose.xi = found.head<6>();
  for (Eigen::Index i = 0; i < seen.count(); ++i)
    pose.residual_px.push_back(residual_px.segment<2>(2 * i).norm());
  if (!pose.covariance.allFinite()) return std::nullopt;
  return pose;
}

}  // namespace facenav::head_tracking
