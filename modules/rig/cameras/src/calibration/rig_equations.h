#pragma once
// The least-squares problem of rig_adjustment.h: its unknowns, their order, and the normal equations of all
// corners and the prior. rig_start.cpp gives the start.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "facenav/cameras/calibrate.h"
#include "rig_adjustment.h"
#include "rig_covariance.h"

namespace facenav::cameras::adjustment {

/// Initial variance of a coordinate, which weights corners against the prior before residuals exist: 0.2 px
/// squared, twice the error of corners in sharp images.
constexpr double kFirstVariance_px2 = 0.04;

struct State {
  CameraModel left, right;
  Eigen::Isometry3d right_T_left = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> left_T_board;
};

/// Order of parameters: left fx fy cx cy d.., right likewise, pose of the right camera, one pose a view.
struct Layout {
  int coefficients;
  int camera() const { return 4 + coefficients; }
  int pose() const { return 2 * camera(); }
  int view(std::size_t i) const { return pose() + 6 + 6 * int(i); }
};

struct Normal {
  Eigen::MatrixXd h;
  Eigen::VectorXd g;
  double squares_px2 = 0;
  int residuals = 0;
};

struct Problem {
  const std::vector<const BoardView*>& views;
  std::vector<std::vector<cv::Point3f>> left_points, right_points;  // on the board, of each view's corners
  LensTerms lens;
  Layout layout;
  cv::Size size;
  double variance_px2 = kFirstVariance_px2;  // variance of a coordinate: weighs corners against the prior

  Problem(const std::vector<const BoardView*>& views, const cv::Size& image_size, const Board& board,
          const LensTerms& lens);
};

State startState(const Problem& problem);

/// Normal equations of all corners and of the prior.
Normal linearise(const Problem& problem, const State& state);
double cost(const Problem& problem, const State& state);
State moved(const Layout& layout, const State& state, const Eigen::VectorXd& step);

/// Information of each view, its board's pose eliminated (Schur complement).
std::vector<ViewInformation> informationOfViews(const Problem& problem, const State& state);
/// Precision of the prior for the parameters shared by all views, in their order.
Eigen::MatrixXd priorPrecision(const Problem& problem, const State& state);

}  // namespace facenav::cameras::adjustment
