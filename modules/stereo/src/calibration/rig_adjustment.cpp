#include "rig_adjustment.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "board_pose.h"
#include "facenav/core/error.h"
#include "facenav/geometry/rotation.h"
#include "rig_covariance.h"
#include "rig_prior.h"

namespace facenav::stereo {
namespace {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using PixelByPoint = Eigen::Matrix<double, 2, 3>;
using PixelByPose = Eigen::Matrix<double, 2, 6>;
using Block = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 12>;  // at most 4 + 8 columns, on the stack

constexpr int kMostIterations = 60;
constexpr double kConverged = 1e-7;  // relative fall of the cost
// Variance of a coordinate that weighs the corners against the prior before the residuals tell it: 0.2 px,
// twice what corners of sharp images show.
constexpr double kFirstVariance_px2 = 0.04;
constexpr int kWeighings = 2;            // of the corners by what the solution before it left
constexpr double kLeastSigma_px = 0.01;  // no corner is known better: keeps noiseless views solvable

struct State {
  CameraModel left, right;
  Isometry3d right_T_left = Isometry3d::Identity();
  std::vector<Isometry3d> left_T_board;
};

// Order of parameters: left fx fy cx cy d.., right likewise, pose of the right camera, one pose a view.
struct Layout {
  int coefficients;
  int camera() const { return 4 + coefficients; }
  int pose() const { return 2 * camera(); }
  int view(std::size_t i) const { return pose() + 6 + 6 * int(i); }
};

struct Normal {
  MatrixXd h;
  VectorXd g;
  double squares_px2 = 0;
  int residuals = 0;
};

struct Problem {
  const std::vector<const BoardView*>& views;
  std::vector<std::vector<cv::Point3f>> left_points, right_points;  // on the board, of each view's corners
  Layout layout;
  cv::Size size;
  double variance_px2 = kFirstVariance_px2;  // of a coordinate: how much a px^2 weighs against the prior

  Problem(const std::vector<const BoardView*>& v, const cv::Size& image_size, const Board& board,
          int coefficients)
      : views(v), layout{coefficients}, size(image_size) {
    for (const BoardView* view : views) {
      left_points.push_back(boardPoints(board, view->left_ids));
      right_points.push_back(boardPoints(board, view->right_ids));
    }
  }
};

Vector3d toEigen(const cv::Point3f& p) { return {p.x, p.y, p.z}; }

// The camera with each distortion coefficient a little larger and smaller: their difference is the
// derivative.
struct Neighbours {
  explicit Neighbours(const CameraModel& camera) : middle(camera) {
    for (int i = 0; i < int(camera.distortion.total()); ++i)
      for (const double step : {kStep, -kStep}) {
        around.push_back(camera);
        around.back().distortion = camera.distortion.clone();
        around.back().distortion.at<double>(i) += step;
      }
  }
  static constexpr double kStep = 1e-5;
  const CameraModel& middle;
  std::vector<CameraModel> around;
};

Block byIntrinsics(const Neighbours& camera, const Vector3d& p, const Vector2d& pixel) {
  const cv::Matx33d& k = camera.middle.k;
  const int coefficients = int(camera.around.size() / 2);
  Block j = Block::Zero(2, 4 + coefficients);
  j(0, 0) = (pixel.x() - k(0, 2)) / k(0, 0);
  j(1, 1) = (pixel.y() - k(1, 2)) / k(1, 1);
  j(0, 2) = j(1, 3) = 1;
  for (int i = 0; i < coefficients; ++i)
    j.col(4 + i) =
        (project(camera.around[2 * i], p) - project(camera.around[2 * i + 1], p)) / (2 * Neighbours::kStep);
  return j;
}

PixelByPose byPose(const PixelByPoint& by_point, const Vector3d& moved) {
  Eigen::Matrix<double, 3, 6> motion;
  motion << -skew(moved), Eigen::Matrix3d::Identity();
  return by_point * motion;
}

void addBlocks(Normal& normal, std::initializer_list<std::pair<int, Block>> blocks, const Vector2d& miss) {
  for (const auto& [row, a] : blocks) {
    normal.g.segment(row, a.cols()) += a.transpose() * miss;
    for (const auto& [col, b] : blocks) normal.h.block(row, col, a.cols(), b.cols()) += a.transpose() * b;
  }
  normal.squares_px2 += miss.squaredNorm();
  normal.residuals += 2;
}

// One view's corners; `pose` is the column of its board's pose.
void addView(const Problem& problem, const State& state, std::size_t v,
             const std::pair<Neighbours, Neighbours>& cameras, int pose, Normal& normal) {
  const Layout& layout = problem.layout;
  PixelByPoint by_point;
  for (std::size_t i = 0; i < problem.left_points[v].size(); ++i) {
    const Vector3d p = state.left_T_board[v] * toEigen(problem.left_points[v][i]);
    const Vector2d left = project(state.left, p, by_point);
    const cv::Point2f& seen = problem.views[v]->left[i];
    addBlocks(normal, {{0, byIntrinsics(cameras.first, p, left)}, {pose, byPose(by_point, p)}},
              Vector2d(seen.x, seen.y) - left);
  }
  for (std::size_t i = 0; i < problem.right_points[v].size(); ++i) {
    const Vector3d p = state.left_T_board[v] * toEigen(problem.right_points[v][i]),
                   q = state.right_T_left * p;
    const Vector2d right = project(state.right, q, by_point);
    const cv::Point2f& seen = problem.views[v]->right[i];
    addBlocks(normal,
              {{layout.camera(), byIntrinsics(cameras.second, q, right)},
               {layout.pose(), byPose(by_point, q)},
               {pose, byPose(by_point * state.right_T_left.linear(), p)}},
              Vector2d(seen.x, seen.y) - right);
  }
}

Normal emptyNormal(int n) { return {MatrixXd::Zero(n, n), VectorXd::Zero(n), 0, 0}; }

Normal linearise(const Problem& problem, const State& state) {
  const std::pair<Neighbours, Neighbours> cameras(state.left, state.right);
  Normal normal = emptyNormal(problem.layout.view(problem.views.size()));
  for (std::size_t v = 0; v < problem.views.size(); ++v)
    addView(problem, state, v, cameras, problem.layout.view(v), normal);
  const PriorTerms prior = priorTerms(state.left, state.right, problem.size);
  const int n = int(prior.jacobian.cols());
  normal.h.topLeftCorner(n, n) += problem.variance_px2 * prior.jacobian.transpose() * prior.jacobian;
  normal.g.head(n) -= problem.variance_px2 * prior.jacobian.transpose() * prior.residuals;
  return normal;
}

// Each view's part with its board's pose eliminated (Schur complement).
std::vector<ViewInformation> informationOfViews(const Problem& problem, const State& state) {
  const std::pair<Neighbours, Neighbours> cameras(state.left, state.right);
  const int shared = problem.layout.view(0);
  std::vector<ViewInformation> views;
  for (std::size_t v = 0; v < problem.views.size(); ++v) {
    Normal normal = emptyNormal(shared + 6);
    addView(problem, state, v, cameras, shared, normal);
    const MatrixXd across = normal.h.topRightCorner(shared, 6);
    const Eigen::LDLT<Matrix6d> pose(normal.h.bottomRightCorner<6, 6>());
    views.push_back({normal.h.topLeftCorner(shared, shared) - across * pose.solve(across.transpose()),
                     normal.g.head(shared) - across * pose.solve(normal.g.tail<6>())});
  }
  return views;
}

double cost(const Problem& problem, const State& state) {
  double squares =
      problem.variance_px2 * priorTerms(state.left, state.right, problem.size).residuals.squaredNorm();
  const auto add = [&](const CameraModel& camera, const Vector3d& p, const cv::Point2f& seen) {
    squares += p.z() > 0 ? (Vector2d(seen.x, seen.y) - project(camera, p)).squaredNorm()
                         : std::numeric_limits<double>::infinity();
  };
  for (std::size_t v = 0; v < problem.views.size(); ++v) {
    for (std::size_t i = 0; i < problem.left_points[v].size(); ++i)
      add(state.left, state.left_T_board[v] * toEigen(problem.left_points[v][i]), problem.views[v]->left[i]);
    for (std::size_t i = 0; i < problem.right_points[v].size(); ++i)
      add(state.right, state.right_T_left * (state.left_T_board[v] * toEigen(problem.right_points[v][i])),
          problem.views[v]->right[i]);
  }
  return squares;
}

CameraModel moved(const CameraModel& camera, const VectorXd& step) {
  CameraModel next = camera;
  next.distortion = camera.distortion.clone();
  next.k(0, 0) += step[0];
  next.k(1, 1) += step[1];
  next.k(0, 2) += step[2];
  next.k(1, 2) += step[3];
  for (int i = 0; i < int(step.size()) - 4; ++i) next.distortion.at<double>(i) += step[4 + i];
  return next;
}

State moved(const Layout& layout, const State& state, const VectorXd& step) {
  State next;
  next.left = moved(state.left, step.head(layout.camera()));
  next.right = moved(state.right, step.segment(layout.camera(), layout.camera()));
  next.right_T_left = expRigid(step.segment<6>(layout.pose())) * state.right_T_left;
  for (std::size_t v = 0; v < state.left_T_board.size(); ++v)
    next.left_T_board.push_back(expRigid(step.segment<6>(layout.view(v))) * state.left_T_board[v]);
  return next;
}

CameraModel startCamera(const Problem& problem, const std::vector<std::vector<cv::Point3f>>& points,
                        std::vector<cv::Point2f> BoardView::*side, const cv::Size& size) {
  std::vector<std::vector<cv::Point2f>> corners;
  for (const BoardView* view : problem.views) corners.push_back(view->*side);
  CameraModel camera;
  camera.k = cv::Matx33d(cv::initCameraMatrix2D(points, corners, size, 1.0));
  camera.distortion = cv::Mat::zeros(1, problem.layout.coefficients, CV_64F);
  const double longest = std::max(size.width, size.height);
  // Boards all held parallel to the image do not tell the focal length: begin with a common lens instead.
  if (!(camera.k(0, 0) > 0.2 * longest && camera.k(0, 0) < 20 * longest))
    camera.k(0, 0) = camera.k(1, 1) = longest;
  return camera;
}

// The relative pose of the view whose relative pose is nearest to all others'.
Isometry3d middlePose(const std::vector<Isometry3d>& poses) {
  double least = std::numeric_limits<double>::infinity();
  Isometry3d middle = poses.front();
  for (const auto& a : poses) {
    double sum = 0;
    for (const auto& b : poses) sum += rotationAngle(a.linear().transpose() * b.linear());
    if (sum < least) {
      least = sum;
      middle = a;
    }
  }
  return middle;
}

State startState(const Problem& problem, const cv::Size& size) {
  State state;
  state.left = startCamera(problem, problem.left_points, &BoardView::left, size);
  state.right = startCamera(problem, problem.right_points, &BoardView::right, size);
  std::vector<Isometry3d> relative;
  for (std::size_t v = 0; v < problem.views.size(); ++v) {
    state.left_T_board.push_back(solveBoardPose(state.left, problem.left_points[v], problem.views[v]->left));
    relative.push_back(solveBoardPose(state.right, problem.right_points[v], problem.views[v]->right) *
                       state.left_T_board.back().inverse());
  }
  state.right_T_left = middlePose(relative);
  return state;
}

State minimise(const Problem& problem, State state) {
  double now = cost(problem, state), damping = 1e-3;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    const Normal normal = linearise(problem, state);
    double fall = 0;
    for (; damping < 1e10 && fall == 0; damping *= 10) {
      MatrixXd damped = normal.h;
      damped.diagonal() += damping * normal.h.diagonal();
      const VectorXd step = damped.ldlt().solve(normal.g);
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

// Of one coordinate of a corner, as the solution leaves it.
double varianceOf(const Problem& problem, const State& state) {
  const Normal normal = linearise(problem, state);
  const double variance = normal.squares_px2 / std::max(1, normal.residuals - int(normal.g.size()));
  return std::max(variance, kLeastSigma_px * kLeastSigma_px);
}

MatrixXd priorPrecision(const Problem& problem, const State& state) {
  const MatrixXd jacobian = priorTerms(state.left, state.right, problem.size).jacobian;
  const int shared = problem.layout.view(0), n = int(jacobian.cols());
  MatrixXd precision = MatrixXd::Zero(shared, shared);
  precision.topLeftCorner(n, n) = jacobian.transpose() * jacobian;
  return precision;
}

bool isSolved(const State& state, const MatrixXd& covariance) {
  return covariance.allFinite() && state.left.k(0, 0) > 0 && state.left.k(1, 1) > 0 &&
         state.right.k(0, 0) > 0 && state.right.k(1, 1) > 0;
}

}  // namespace

RigFit adjustRig(const std::vector<const BoardView*>& views, const cv::Size& size, const Board& board,
                 int coefficients) {
  Problem problem(views, size, board, coefficients);
  State state = minimise(problem, startState(problem, size));
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
  RigFit fit;
  fit.rig.width_px = size.width;
  fit.rig.height_px = size.height;
  fit.rig.left = state.left;
  fit.rig.right = state.right;
  fit.rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(state.right_T_left);
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

}  // namespace facenav::stereo
