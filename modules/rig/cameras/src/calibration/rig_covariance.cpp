#include "rig_covariance.h"
#include "facenav/geometry/normal_equations.h"

#include <Eigen/Dense>
#include <algorithm>

namespace facenav::cameras {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd inverse(const MatrixXd& symmetric) {
  // Solves with a diagonal of 1, because parameters have very different units (focal lengths in px, k3).
  const VectorXd scale = symmetric.diagonal().cwiseMax(1e-30).cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * symmetric * scale.asDiagonal();
  return scale.asDiagonal() * inverseOfSymmetric(scaled) * scale.asDiagonal();
}

// Sum of squares of the changes when each view in turn is left out.
MatrixXd jackknife(const std::vector<ViewInformation>& views, double weight, const MatrixXd& information) {
  MatrixXd sum = MatrixXd::Zero(information.rows(), information.cols());
  for (const ViewInformation& view : views) {
    const VectorXd change = inverse(information - weight * view.normal) * (weight * view.score);
    sum += change * change.transpose();
  }
  return sum * double(views.size() - 1) / double(views.size());
}

}  // namespace

RobustCovariance robustCovariance(const std::vector<ViewInformation>& views, double variance_px2,
                                  const MatrixXd& prior) {
  const double weight = 1 / variance_px2;
  MatrixXd from_views = MatrixXd::Zero(prior.rows(), prior.cols());
  for (const ViewInformation& view : views) from_views += weight * view.normal;
  const MatrixXd information = from_views + prior, bread = inverse(information);
  const MatrixXd measured = jackknife(views, weight, information);
  const MatrixXd independent = bread * from_views * bread;
  RobustCovariance result;
  result.design_effect =
      std::max(1.0, (information * measured).trace() / std::max(1e-9, (information * independent).trace()));
  // n views span at most n directions and constrain each weakly. So the measured covariance is shrunk towards
  // the shape for independent corners, weighted as one view per parameter.
  const double share = double(views.size()) / double(views.size() + std::size_t(prior.rows()));
  result.covariance =
      share * measured + (1 - share) * result.design_effect * independent + bread * prior * bread;
  return result;
}

}  // namespace facenav::cameras
