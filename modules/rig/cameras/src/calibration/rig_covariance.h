#pragma once
// Covariance of a rig's parameters from the differences between its views. Corners of one view share their
// errors (blur, compression, a bent board, misfit of the lens model), so a view counts as one observation and
// not as a hundred: errors from the normal equations alone are several times too small. Jackknife over views
// by one linear step each (the CR3 estimator: Bell, McCaffrey 2002, Survey Methodology 28).

#include <Eigen/Core>
#include <vector>

namespace facenav::cameras {

/// Information of one view about the rig, its board pose eliminated, per px^2 of noise variance.
struct ViewInformation {
  Eigen::MatrixXd normal;
  Eigen::VectorXd score;
};

struct RobustCovariance {
  Eigen::MatrixXd covariance;
  double design_effect = 1;  // >= 1: variance of the parameters relative to that for independent corners
};

/// Covariance of the rig's parameters. `variance_px2`: variance of one coordinate of a corner, as weighted in
/// the solution; `prior`: the prior's precision.
RobustCovariance robustCovariance(const std::vector<ViewInformation>& views, double variance_px2,
                                  const Eigen::MatrixXd& prior);

}  // namespace facenav::cameras
