#include "rig_adjustment.h"

#include <Eigen/Dense>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/geometry/normal_equations.h"
#include "rig_covariance.h"
#include "rig_equations.h"

namespace facenav::cameras {
namespace {

using namespace adjustment;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kMostIterations = 60;
constexpr double kConverged = 1e-7;  // relative decrease of the cost
constexpr int kWeighings = 2;        // rounds that weight the corners by the residuals of the solution before
constexpr double kLeastSigma_px = 0.01;  // no corner is more exact: keeps noiseless views solvable

State minimise(const Problem& problem, State state) {
  double now = cost(problem, state), damping = 1e-3;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    const Normal normal = linearise(problem, state);
    double fall = 0;
    for (; damping < 1e10 && fall == 0; damping *= 10) {
      MatrixXd damped = normal.h;
      damped.diagonal() += damping * normal.h.diagonal();
      const VectorXd step = solveSymmetric(damped, normal.g);
      if (!step.allFinite()) continue;
      const State next = moved(problem.layout, state, step);
      const double after = cost(problem, next);
      if (!(after < now)) continue;
      fall = (now - after) / now;
      state = next;
      now = after;
      damping *= 1e-2;
    }
    if (fall < kConverged) break;
  }
  return state;
}

// Variance of one coordinate of a corner, from the residuals.
double varianceOf(const Problem& problem, const State& state) {
  const Normal normal = linearise(problem, state);
  const double variance = normal.squares_px2 / std::max(1, normal.residuals - int(normal.g.size()));
  return std::max(variance, kLeastSigma_px * kLeastSigma_px);
}

bool isSolved(const State& state, const MatrixXd& covariance) {
  return covariance.allFinite() && state.left.k(0, 0) > 0 && state.left.k(1, 1) > 0 &&
         state.right.k(0, 0) > 0 && state.right.k(1, 1) > 0;
}

// The result: rig, covariance, and the errors that a user looks at first.
RigFit fitOf(const Problem& problem, const State& state, const MatrixXd& covariance) {
  RigFit fit;
  fit.rig.width_px = problem.size.width;
  fit.rig.height_px = problem.size.height;
  fit.rig.left = state.left;
  fit.rig.right = state.right;
  fit.rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(state.right_T_left);
  if (!problem.lens.is_tangential)
    for (CameraModel* camera : {&fit.rig.left, &fit.rig.right})
      camera->distortion.at<double>(2) = camera->distortion.at<double>(3) = 0;
  const int shared = problem.layout.view(0);
  fit.rig.covariance = cv::Mat(shared, shared, CV_64F);
  for (int i = 0; i < shared; ++i)
    for (int j = 0; j < shared; ++j) fit.rig.covariance.at<double>(i, j) = covariance(i, j);
  const int right = problem.layout.camera(), t = problem.layout.pose() + 3;
  for (const int i : {0, 1, right, right + 1})
    fit.focal_sigma_px = std::max(fit.focal_sigma_px, std::sqrt(std::max(0.0, covariance(i, i))));
  const Vector3d along = state.right_T_left.translation().normalized();
  fit.baseline_sigma_mm = std::sqrt(std::max(0.0, along.dot(covariance.block<3, 3>(t, t) * along)));
  return fit;
}

}  // namespace

RigFit adjustRig(const std::vector<const BoardView*>& views, const cv::Size& size, const Board& board,
                 const LensTerms& lens) {
  Problem problem(views, size, board, lens);
  State state = minimise(problem, startState(problem));
  for (int weighing = 0; weighing < kWeighings; ++weighing) {
    const double variance = varianceOf(problem, state);
    problem.variance_px2 = variance * robustCovariance(informationOfViews(problem, state), variance,
                                                       priorPrecision(problem, state))
                                          .design_effect;
    if (!std::isfinite(problem.variance_px2)) break;
    state = minimise(problem, state);
  }
  const MatrixXd covariance = robustCovariance(informationOfViews(problem, state), problem.variance_px2,
                                               priorPrecision(problem, state))
                                  .covariance;
  if (!isSolved(state, covariance))
    throw Error("the views do not determine the cameras", {},
                "take pairs of the board at different angles and distances");
  return fitOf(problem, state, covariance);
}

}  // namespace facenav::cameras
