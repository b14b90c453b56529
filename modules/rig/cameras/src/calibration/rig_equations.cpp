#include "rig_equations.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "facenav/geometry/rotation.h"
#include "rig_prior.h"

namespace facenav::cameras::adjustment {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using PixelByPoint = Eigen::Matrix<double, 2, 3>;
using PixelByPose = Eigen::Matrix<double, 2, 6>;
using Block = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, 12>;  // at most 4 + 8 columns, on the stack

Vector3d toEigen(const cv::Point3f& p) { return {p.x, p.y, p.z}; }

// The camera with each distortion coefficient slightly larger and smaller: differences give the derivatives.
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

// Adds one view's corners; `pose`: the column of its board's pose.
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

PriorTerms priorOf(const Problem& problem, const State& state) {
  return priorTerms(state.left, state.right, problem.size, problem.lens.is_tangential);
}

}  // namespace

Problem::Problem(const std::vector<const BoardView*>& v, const cv::Size& image_size, const Board& board,
                 const LensTerms& terms)
    : views(v), lens(terms), layout{terms.coefficients}, size(image_size) {
  for (const BoardView* view : views) {
    left_points.push_back(boardPoints(board, view->left_ids));
    right_points.push_back(boardPoints(board, view->right_ids));
  }
}

Normal linearise(const Problem& problem, const State& state) {
  const std::pair<Neighbours, Neighbours> cameras(state.left, state.right);
  Normal normal = emptyNormal(problem.layout.view(problem.views.size()));
  for (std::size_t v = 0; v < problem.views.size(); ++v)
    addView(problem, state, v, cameras, problem.layout.view(v), normal);
  const PriorTerms prior = priorOf(problem, state);
  const int n = int(prior.jacobian.cols());
  normal.h.topLeftCorner(n, n) += problem.variance_px2 * prior.jacobian.transpose() * prior.jacobian;
  normal.g.head(n) -= problem.variance_px2 * prior.jacobian.transpose() * prior.residuals;
  return normal;
}

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
  double squares = problem.variance_px2 * priorOf(problem, state).residuals.squaredNorm();
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

namespace {

CameraModel movedCamera(const CameraModel& camera, const VectorXd& step) {
  CameraModel next = camera;
  next.distortion = camera.distortion.clone();
  next.k(0, 0) += step[0];
  next.k(1, 1) += step[1];
  next.k(0, 2) += step[2];
  next.k(1, 2) += step[3];
  for (int i = 0; i < int(step.size()) - 4; ++i) next.distortion.at<double>(i) += step[4 + i];
  return next;
}

}  // namespace

State moved(const Layout& layout, const State& state, const VectorXd& step) {
  State next;
  next.left = movedCamera(state.left, step.head(layout.camera()));
  next.right = movedCamera(state.right, step.segment(layout.camera(), layout.camera()));
  next.right_T_left = expRigid(step.segment<6>(layout.pose())) * state.right_T_left;
  for (std::size_t v = 0; v < state.left_T_board.size(); ++v)
    next.left_T_board.push_back(expRigid(step.segment<6>(layout.view(v))) * state.left_T_board[v]);
  return next;
}

MatrixXd priorPrecision(const Problem& problem, const State& state) {
  const MatrixXd jacobian = priorOf(problem, state).jacobian;
  const int shared = problem.layout.view(0), n = int(jacobian.cols());
  MatrixXd precision = MatrixXd::Zero(shared, shared);
  precision.topLeftCorner(n, n) = jacobian.transpose() * jacobian;
  return precision;
}

}  // namespace facenav::cameras::adjustment
