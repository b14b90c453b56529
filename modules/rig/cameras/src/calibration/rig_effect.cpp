#include "facenav/cameras/head_effect.h"

#include <Eigen/Dense>
#include <cmath>

#include "facenav/geometry/rotation.h"
#include "rig/parameter_steps.h"

namespace facenav::cameras {
namespace {

constexpr double kFace_mm = 60.0;       // half the width and height of the visible part of a face
constexpr double kFaceDepth_mm = 40.0;  // from the cheeks to the tip of the nose
constexpr double kLength_mm = 100.0, kMotion_mm = 20.0, kTurn_rad = 5 * kRadPerDeg;

using Points = Eigen::Matrix3Xd;

// The points that the rig `other` measures when `rig` is the truth.
Points reported(const StereoRig& rig, const StereoRig& other, const Points& points_mm) {
  Points out(3, points_mm.cols());
  for (int i = 0; i < points_mm.cols(); ++i) {
    const Eigen::Vector3d p = points_mm.col(i);
    out.col(i) =
        triangulate(other, project(rig.left, p), project(rig.right, rig.right_T_left.isometry() * p)).mm;
  }
  return out;
}

Points faceAround(const Eigen::Vector3d& middle_mm) {
  Points points(3, 25);
  for (int i = 0; i < 25; ++i) {
    const double x = (i % 5 - 2) / 2.0, y = (i / 5 - 2) / 2.0;
    points.col(i) = middle_mm + Eigen::Vector3d(kFace_mm * x, kFace_mm * y,
                                                kFaceDepth_mm * (0.5 * (x * x + y * y) - 0.5));
  }
  return points;
}

Eigen::Isometry3d motionBetween(const Points& before, const Points& after) {
  return Eigen::Isometry3d(Eigen::umeyama(before, after, false));
}

// Motions along and about each axis: adds the mean of the squared errors of the three.
void addMotion(const StereoRig& rig, const StereoRig& other, const Points& face, HeadEffect& squares) {
  const Eigen::Vector3d middle = face.rowwise().mean();
  const Points seen = reported(rig, other, face);
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.translate(middle + kMotion_mm * Eigen::Vector3d::Unit(axis));
    motion.rotate(Eigen::AngleAxisd(kTurn_rad, Eigen::Vector3d::Unit(axis)));
    motion.translate(-middle);
    Points moved(3, face.cols());
    for (int i = 0; i < face.cols(); ++i) moved.col(i) = motion * Eigen::Vector3d(face.col(i));
    const Eigen::Isometry3d told = motionBetween(seen, reported(rig, other, moved));
    const Eigen::Vector3d at = seen.rowwise().mean();
    const double turn_deg = rotationAngle(told.linear() * motion.linear().transpose()) * kDegPerRad;
    squares.motion_deg += turn_deg * turn_deg / 3;
    squares.motion_mm += ((told * at - at) - (motion * middle - middle)).squaredNorm() / 3;
  }
}

void addLengths(const StereoRig& rig, const StereoRig& other, const Eigen::Vector3d& middle,
                HeadEffect& squares) {
  for (int axis = 0; axis < 3; ++axis) {
    Points ends(3, 2);
    const Eigen::Vector3d half = 0.5 * kLength_mm * Eigen::Vector3d::Unit(axis);
    ends.col(0) = middle - half;
    ends.col(1) = middle + half;
    const Points seen = reported(rig, other, ends);
    const double error_mm = (seen.col(1) - seen.col(0)).norm() - kLength_mm;
    squares.length_mm += error_mm * error_mm / 3;
  }
}

}  // namespace

HeadEffect effectAtHead(const StereoRig& rig, const Eigen::Vector3d& middle_mm) {
  HeadEffect effect;
  effect.distance_mm = middle_mm.norm();
  if (rig.covariance.empty()) return effect;
  const Points face = faceAround(middle_mm);
  const Eigen::MatrixXd steps = principalSteps(rig.covariance);
  for (int i = 0; i < steps.cols(); ++i) {
    const StereoRig other = stepped(rig, steps.col(i));
    const Eigen::Vector3d seen = reported(rig, other, middle_mm);
    effect.point_mm += (seen - middle_mm).squaredNorm();
    effect.depth_mm += std::pow(seen.norm() - middle_mm.norm(), 2);
    addLengths(rig, other, middle_mm, effect);
    addMotion(rig, other, face, effect);
  }
  for (double* figure :
       {&effect.point_mm, &effect.depth_mm, &effect.length_mm, &effect.motion_mm, &effect.motion_deg})
    *figure = std::sqrt(*figure);
  return effect;
}

}  // namespace facenav::cameras
