// Start of the adjustment of a rig: OpenCV's closed forms, each camera alone.

#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "board_pose.h"
#include "facenav/geometry/rotation.h"
#include "rig_equations.h"

namespace facenav::cameras::adjustment {
namespace {

using Eigen::Isometry3d;

CameraModel startCamera(const Problem& problem, const std::vector<std::vector<cv::Point3f>>& points,
                        std::vector<cv::Point2f> BoardView::*side) {
  std::vector<std::vector<cv::Point2f>> corners;
  for (const BoardView* view : problem.views) corners.push_back(view->*side);
  CameraModel camera;
  camera.k = cv::Matx33d(cv::initCameraMatrix2D(points, corners, problem.size, 1.0));
  camera.distortion = cv::Mat::zeros(1, problem.layout.coefficients, CV_64F);
  const double longest = std::max(problem.size.width, problem.size.height);
  // Boards all parallel to the image do not determine the focal length: start with a common lens instead.
  if (!(camera.k(0, 0) > 0.2 * longest && camera.k(0, 0) < 20 * longest))
    camera.k(0, 0) = camera.k(1, 1) = longest;
  return camera;
}

// Relative pose nearest to those of all other views.
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

}  // namespace

State startState(const Problem& problem) {
  State state;
  state.left = startCamera(problem, problem.left_points, &BoardView::left);
  state.right = startCamera(problem, problem.right_points, &BoardView::right);
  std::vector<Isometry3d> relative;
  for (std::size_t v = 0; v < problem.views.size(); ++v) {
    state.left_T_board.push_back(solveBoardPose(state.left, problem.left_points[v], problem.views[v]->left));
    relative.push_back(solveBoardPose(state.right, problem.right_points[v], problem.views[v]->right) *
                       state.left_T_board.back().inverse());
  }
  state.right_T_left = middlePose(relative);
  return state;
}

}  // namespace facenav::cameras::adjustment
