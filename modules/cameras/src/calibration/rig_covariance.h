#pragma once
// The covariance of a rig's parameters from how far its views contradict one another. Corners of one view
// share their errors (blur, compression, a bent board, what the lens model leaves), so that a view counts as
// one observation and not as a hundred: the normal equations alone state errors several times too small.
// Jackknife over views by one linear step each (the CR3 estimator: Bell, McCaffrey 2002, Survey Methodology
// 28).

#include <Eigen/Core>
#include <vector>

namespace facenav::cameras {

/// What one view tells of the rig's parameters once its board pose is solved for, per px^2 of noise variance.
struct ViewInformation {
  Eigen::MatrixXd normal;
  Eigen::VectorXd score;
};

struct RobustCovariance {
  Eigen::MatrixXd covariance;
  double design_effect = 1;  // >= 1: variance of the parameters over what independent corners would give
};

/// `variance_px2` of one coordinate of a corner, as the solution weighed it; `prior`: the prior's precision.
RobustCovariance robustCovariance(const std::vector<ViewInformation>& views, double variance_px2,
                                  const Eigen::MatrixXd& prior);

}  // namespace facenav::cameras
