#include "board_pose.h"

#include <Eigen/Dense>
#include <opencv2/calib3d.hpp>

#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav::cameras {
namespace {

struct Equations {
  Matrix6d normal = Matrix6d::Zero();
  Vector6d rhs = Vector6d::Zero();
  double squares_px2 = 0;
};

// Adds the corners of one image. `camera_T_left` is identity for the left one.
void addImage(const CameraModel& camera, const Eigen::Isometry3d& camera_T_left,
              const Eigen::Isometry3d& left_T_board, const std::vector<cv::Point3f>& points,
              const std::vector<cv::Point2f>& corners, Equations& sum) {
  sum.squares_px2 = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = left_T_board * Eigen::Vector3d(points[i].x, points[i].y, points[i].z);
    Eigen::Matrix<double, 2, 3> by_point;
    const Eigen::Vector2d miss =
        Eigen::Vector2d(corners[i].x, corners[i].y) - project(camera, camera_T_left * p, by_point);
    Eigen::Matrix<double, 3, 6> by_pose;
    by_pose << -skew(p), Eigen::Matrix3d::Identity();
    const Eigen::Matrix<double, 2, 6> j = by_point * camera_T_left.linear() * by_pose;
    sum.normal += j.transpose() * j;
    sum.rhs += j.transpose() * miss;
    sum.squares_px2 += miss.squaredNorm();
  }
}

}  // namespace

Eigen::Isometry3d solveBoardPose(const CameraModel& camera, const std::vector<cv::Point3f>& points,
                                 const std::vector<cv::Point2f>& corners) {
  cv::Vec3d rotation, translation;
  cv::solvePnP(points, corners, camera.k, camera.distortion, rotation, translation);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = expRotation({rotation[0], rotation[1], rotation[2]});
  pose.translation() = Eigen::Vector3d(translation[0], translation[1], translation[2]);
  return pose;
}

ViewFit fitBoard(const StereoRig& rig, const BoardView& view, const Board& board) {
  const auto left_points = boardPoints(board, view.left_ids),
             right_points = boardPoints(board, view.right_ids);
  ViewFit fit;
  fit.camera_T_board = solveBoardPose(rig.left, left_points, view.left);
  for (int iteration = 0; iteration < 20; ++iteration) {
    Equations sum;
    addImage(rig.left, Eigen::Isometry3d::Identity(), fit.camera_T_board, left_points, view.left, sum);
    fit.left_rms_px = std::sqrt(sum.squares_px2 / double(left_points.size()));
    addImage(rig.right, rig.right_T_left.isometry(), fit.camera_T_board, right_points, view.right, sum);
    fit.right_rms_px = std::sqrt(sum.squares_px2 / double(right_points.size()));
    const Vector6d step = solveSymmetric(sum.normal, sum.rhs);
    if (!step.allFinite() || step.norm() < 1e-9) break;
    fit.camera_T_board = expRigid(step) * fit.camera_T_board;
  }
  return fit;
}

}  // namespace facenav::cameras
