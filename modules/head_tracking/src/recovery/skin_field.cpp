#include "skin_field.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"

namespace facenav::head_tracking {
namespace {

// Fitted on one real person (60 motions of five moments, three pairs of cameras against each other) and on
// 15 moments of a room (`simulate moments`, seeds 1 to 3, errors against truth); some twenty settings were
// tried.
constexpr double kSpacing_mm = 60.0;  // between the field's nodes, and its length scale
constexpr double kSharedPart = 0.3;   // of a part's mobility, that the field has; windows move by all of it
constexpr double kLeastReach = 0.3;   // of a node, at some match: a node far from all is left out
constexpr double kFreedom = 1.0;      // of Student's t: Cauchy
constexpr double kLeastScale = 0.3;   // of the errors by those expected
constexpr double kMedianLength = 1.177;  // of a normal error in two dimensions, by its standard deviation
constexpr double kNoPrior = 1e-9;        // of the head's motion
constexpr int kRounds = 12;

// How each point's skin follows the nodes (rows: points; unit length). A node has three unknowns.
Eigen::MatrixXd shares(const SkinPoints& points, const std::vector<SkinMatch>& matches) {
  Eigen::Array2d low = Eigen::Array2d::Constant(1e9), high = -low;
  for (const auto& match : matches) {
    const Eigen::Array2d at = points[std::size_t(match.point)].mm.head<2>().array();
    low = low.min(at), high = high.max(at);
  }
  std::vector<Eigen::Vector2d> nodes;
  for (double x = low.x() - kSpacing_mm / 2; x < high.x() + kSpacing_mm; x += kSpacing_mm)
    for (double y = low.y() - kSpacing_mm / 2; y < high.y() + kSpacing_mm; y += kSpacing_mm)
      nodes.emplace_back(x, y);
  Eigen::MatrixXd share(Eigen::Index(matches.size()), Eigen::Index(nodes.size()));
  for (Eigen::Index i = 0; i < share.rows(); ++i)
    for (Eigen::Index k = 0; k < share.cols(); ++k)
      share(i, k) =
          std::exp(-(points[std::size_t(matches[std::size_t(i)].point)].mm.head<2>() - nodes[std::size_t(k)])
                        .squaredNorm() /
                   (kSpacing_mm * kSpacing_mm));
  Eigen::Index used = 0;
  for (Eigen::Index k = 0; k < share.cols(); ++k)
    if (share.col(k).maxCoeff() > kLeastReach) share.col(used++) = share.col(k).eval();
  share.conservativeResize(Eigen::NoChange, used);
  share.rowwise().normalize();
  return share;
}

// Rows: two of each match. Columns: xi, then three of each node, in standard deviations of the prior.
Eigen::MatrixXd designOf(const SkinPoints& points, const std::vector<SkinMatch>& matches) {
  const Eigen::MatrixXd share = shares(points, matches);
  Eigen::MatrixXd design(2 * share.rows(), 6 + 3 * share.cols());
  for (Eigen::Index i = 0; i < share.rows(); ++i) {
    const SkinMatch& match = matches[std::size_t(i)];
    const double moved_mm = kSharedPart * points[std::size_t(match.point)].mobility_mm;
    design.block<2, 6>(2 * i, 0) = match.jacobian;
    for (Eigen::Index k = 0; k < share.cols(); ++k)
      design.block<2, 3>(2 * i, 6 + 3 * k) = moved_mm * share(i, k) * match.jacobian.rightCols<3>();
  }
  return design;
}

struct Observations {
  Eigen::MatrixXd design;
  Eigen::VectorXd offset_px;               // two of each match
  std::vector<Eigen::Matrix2d> precision;  // of each match

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

// Cauchy weights of the matches, by their residuals in units of the errors that this frame shows.
std::vector<double> weightsOf(const Observations& seen, const Eigen::VectorXd& residual_px) {
  std::vector<double> distance, weight;
  for (Eigen::Index i = 0; i < seen.count(); ++i) {
    const Eigen::Vector2d r = residual_px.segment<2>(2 * i);
    distance.push_back(std::sqrt(std::max(0.0, r.dot(seen.precision[std::size_t(i)] * r))));
  }
  const double scale = std::max(kLeastScale, upperMedian(distance) / kMedianLength);
  for (const double d : distance) weight.push_back((kFreedom + 2) / (kFreedom + std::pow(d / scale, 2)));
  return weight;
}

// Most of the skin stays, a part of it moves far: each node's prior is Student's t, too.
Eigen::VectorXd priorOf(const Eigen::VectorXd& found) {
  Eigen::VectorXd prior = Eigen::VectorXd::Constant(found.size(), kNoPrior);
  for (Eigen::Index k = 6; k < found.size(); k += 3)
    prior.segment<3>(k).setConstant((kFreedom + 3) / (kFreedom + found.segment<3>(k).squaredNorm()));
  return prior;
}

}  // namespace

std::optional<SkinFieldPose> solveWithSkinField(const SkinPoints& points,
                                                const std::vector<SkinMatch>& matches) {
  if (matches.empty()) return std::nullopt;
  const Observations seen = observationsOf(points, matches);
  std::vector<double> weight(matches.size(), 1.0);
  Eigen::VectorXd found = Eigen::VectorXd::Zero(seen.design.cols());
  Eigen::MatrixXd weighted(seen.design.rows(), seen.design.cols());
  SkinFieldPose pose;
  for (int round = 0; round < kRounds; ++round) {
    for (Eigen::Index i = 0; i < seen.count(); ++i)
      weighted.middleRows<2>(2 * i).noalias() =
          weight[std::size_t(i)] * seen.precision[std::size_t(i)] * seen.design.middleRows<2>(2 * i);
    Eigen::MatrixXd normal = seen.design.transpose() * weighted;
    normal.diagonal() += priorOf(found);
    const auto factor = normal.ldlt();
    found = factor.solve(weighted.transpose() * seen.offset_px);
    if (!found.allFinite()) return std::nullopt;
    weight = weightsOf(seen, seen.offset_px - seen.design * found);
    if (round == kRounds - 1)
      pose.covariance = factor.solve(Eigen::MatrixXd::Identity(normal.rows(), 6)).topRows<6>();
  }
  pose.xi = found.head<6>();
  if (!pose.covariance.allFinite()) return std::nullopt;
  return pose;
}

}  // namespace facenav::head_tracking
