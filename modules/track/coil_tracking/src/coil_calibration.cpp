#include "facenav/coil_tracking/coil_calibration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/whole_file.h"
#include "facenav/geometry/median_pose.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/geometry/rotation.h"

namespace facenav::coil_tracking {
namespace {

constexpr int kFewestFrames = 5, kFewestPoses = 10;
constexpr double kLeastOutlier_mm = 0.5;  // smaller distances are never outliers
constexpr double kLeastTurn_rad = 20 * kRadPerDeg, kShortestArm_mm = 20.0;
constexpr double kSharedFrames = 4;  // neighbouring frames share their errors, so one in four is independent

Eigen::Matrix3d meanRotation(const std::vector<Eigen::Isometry3d>& poses) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const auto& pose : poses) sum += pose.linear();
  return nearestRotation(sum);
}

Eigen::Isometry3d meanPose(const std::vector<Eigen::Isometry3d>& poses) {
  Eigen::Isometry3d mean = Eigen::Isometry3d::Identity();
  mean.linear() = meanRotation(poses);
  mean.translation().setZero();
  for (const auto& pose : poses) mean.translation() += pose.translation() / double(poses.size());
  return mean;
}

/// Removes outliers; `distance` measures from the median. Three times the median distance is 4.6 standard
/// deviations in space.
template <class T, class Distance>
std::vector<T> withoutOutliers(const std::vector<T>& all, Distance distance) {
  std::vector<double> distances;
  for (const T& one : all) distances.push_back(distance(one));
  const double limit = std::max(kLeastOutlier_mm, kSignificant * upperMedian(distances));
  std::vector<T> kept;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (distances[i] <= limit) kept.push_back(all[i]);
  return kept;
}

/// Least-squares solution of R_i c - tip = -t_i.
Pivot solvePivot(const std::vector<RigidTransform<Camera, Marker>>& poses, Eigen::Vector3d& tip_mm) {
  Matrix6d normal = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  for (const auto& pose : poses) {
    Eigen::Matrix<double, 3, 6> row;
    row << pose.rotation(), -Eigen::Matrix3d::Identity();
    normal += row.transpose() * row;
    right -= row.transpose() * pose.translation_mm();
  }
  const Vector6d solution = solveSymmetric(normal, right);
  tip_mm = solution.tail<3>();
  Pivot pivot;
  pivot.in_marker_mm = solution.head<3>();
  double squares = 0;
  for (const auto& pose : poses)
    squares += (pose.rotation() * pivot.in_marker_mm + pose.translation_mm() - tip_mm).squaredNorm();
  pivot.used = int(poses.size());
  pivot.rms_mm = std::sqrt(squares / double(poses.size()));
  const double variance = squares / std::max(1.0, 3.0 * double(poses.size()) - 6.0);
  pivot.covariance = kSharedFrames * variance * inverseOf(normal).topLeftCorner<3, 3>();
  return pivot;
}

/// Angle by which the poses turn about their second-best axis.
double secondTurn_rad(const std::vector<RigidTransform<Camera, Marker>>& poses) {
  std::vector<Eigen::Isometry3d> all;
  for (const auto& pose : poses) all.push_back(pose.isometry());
  const Eigen::Matrix3d mean = meanRotation(all);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& pose : all) {
    const Eigen::Vector3d turn = logRotation(mean.transpose() * pose.linear());
    scatter += turn * turn.transpose() / double(all.size());
  }
  return 2 * std::sqrt(std::max(0.0, principalAxes(scatter).values[1]));
}

}  // namespace

CoilCalibration calibrateWithJig(const std::vector<JigObservation>& observations,
                                 const RigidTransform<Coil, Marker>& coil_T_jig) {
  std::vector<Eigen::Isometry3d> poses;
  for (const auto& s : observations)
    poses.push_back((s.camera_T_marker.inverse() * s.camera_T_jig).isometry() *
                    coil_T_jig.inverse().isometry());
  const auto refuse = [&](std::size_t count) {
    throw Error(
        "coil's marker and jig are seen together in only " + std::to_string(count) + " frames that agree", {},
        "show both to both cameras, from several directions");
  };
  if (int(poses.size()) < kFewestFrames) refuse(poses.size());
  // Distances at the origin and at 100 mm along an axis, so that rotation outliers count too.
  std::vector<double> x, y, z;
  for (const auto& pose : poses) {
    x.push_back(pose.translation().x());
    y.push_back(pose.translation().y());
    z.push_back(pose.translation().z());
  }
  const Eigen::Vector3d middle(upperMedian(x), upperMedian(y), upperMedian(z));
  std::vector<Eigen::Matrix3d> rotations;
  for (const auto& pose : poses) rotations.push_back(pose.linear());
  const Eigen::Matrix3d turned = medianRotation(rotations);
  const auto kept = withoutOutliers(poses, [&](const Eigen::Isometry3d& pose) {
    return (pose.translation() - middle).norm() + 100 * rotationAngle(turned.transpose() * pose.linear());
  });
  if (int(kept.size()) < kFewestFrames) refuse(kept.size());
  const Eigen::Isometry3d mean = meanPose(kept);
  double squares_mm2 = 0, squares_rad2 = 0;
  for (const auto& pose : kept) {
    squares_mm2 += (pose.translation() - mean.translation()).squaredNorm();
    squares_rad2 += std::pow(rotationAngle(mean.linear().transpose() * pose.linear()), 2);
  }
  const double n = double(kept.size()), independent = std::max(1.0, n / kSharedFrames);
  CoilCalibration calibration;
  calibration.marker_T_coil = RigidTransform<Marker, Coil>::fromIsometry(mean);
  calibration.method = "jig";
  calibration.rms_mm = std::sqrt(squares_mm2 / n);
  calibration.sigma_mm = std::sqrt(squares_mm2 / (n - 1) / independent);
  calibration.sigma_deg = std::sqrt(squares_rad2 / (n - 1) / independent) * kDegPerRad;
  calibration.frames = int(observations.size());
  calibration.used = int(kept.size());
  return calibration;
}

Pivot fitPivot(const std::vector<RigidTransform<Camera, Marker>>& poses) {
  if (int(poses.size()) < kFewestPoses)
    throw Error("the marker is seen in only " + std::to_string(poses.size()) + " frames of the pivoting", {},
                "turn the coil about its tip for some seconds, marker towards the cameras");
  if (secondTurn_rad(poses) < kLeastTurn_rad)
    throw Error("the coil was hardly turned while it was pivoted", {},
                "tilt it by 30 degrees and more to the sides and back and forth");
  Eigen::Vector3d tip_mm;
  const Pivot first = solvePivot(poses, tip_mm);
  const auto kept = withoutOutliers(poses, [&](const RigidTransform<Camera, Marker>& pose) {
    return (pose.rotation() * first.in_marker_mm + pose.translation_mm() - tip_mm).norm();
  });
  Pivot pivot = solvePivot(kept, tip_mm);
  pivot.poses = int(poses.size());
  return pivot;
}

CoilCalibration calibrateWithPivots(const Pivot& centre, const Pivot& handle, const Pivot& side) {
  const Eigen::Vector3d from_handle = centre.in_marker_mm - handle.in_marker_mm,
                        to_side = side.in_marker_mm - centre.in_marker_mm;
  const Eigen::Vector3d y = from_handle.normalized(), across = to_side - y * y.dot(to_side);
  if (!(from_handle.norm() >= kShortestArm_mm && across.norm() >= kShortestArm_mm))
    throw Error("centre, handle and side of the coil lie too near to each other or in one line", {},
                "choose points at least 20 mm apart");
  const Eigen::Vector3d x = across.normalized();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << x, y, x.cross(y);
  pose.translation() = centre.in_marker_mm;
  CoilCalibration calibration;
  calibration.marker_T_coil = RigidTransform<Marker, Coil>::fromIsometry(pose);
  calibration.method = "pivot";
  calibration.rms_mm = std::sqrt(
      (centre.rms_mm * centre.rms_mm + handle.rms_mm * handle.rms_mm + side.rms_mm * side.rms_mm) / 3);
  calibration.sigma_mm = std::sqrt(centre.covariance.trace());
  const double y_variance = (centre.covariance + handle.covariance).trace() / from_handle.squaredNorm(),
               x_variance = (centre.covariance + side.covariance).trace() / across.squaredNorm();
  calibration.sigma_deg = std::sqrt(y_variance + x_variance) * kDegPerRad;
  calibration.frames = centre.poses + handle.poses + side.poses;
  calibration.used = centre.used + handle.used + side.used;
  return calibration;
}

void writeCalibratedCoil(CoilModel coil, const CoilCalibration& calibration,
                         const std::filesystem::path& path, const std::filesystem::path& source) {
  FACENAV_EXPECT(!coil.markers.empty(), "a coil needs a marker");
  using Json = nlohmann::ordered_json;
  const Json before = source.empty() ? Json::object() : Json::parse(readWholeFile(source));
  const auto old_marker_T_coil = coil.markers.front().coil_T_marker.inverse();
  for (MarkerModel& marker : coil.markers)  // keeps the pose of this marker relative to the first
    marker.coil_T_marker = calibration.marker_T_coil.inverse() * (old_marker_T_coil * marker.coil_T_marker);
  writeCoil(coil, path);
  Json json = Json::parse(readWholeFile(path));
  for (const auto& [key, value] : before.items())
    if (!json.contains(key) && key != "marker" && key != "marker_T_coil" && key != "markers")
      json[key] = value;
  json["calibration"] = {{"method", calibration.method},
                         {"rms_mm", calibration.rms_mm},
                         {"sigma_mm", calibration.sigma_mm},
                         {"sigma_deg", calibration.sigma_deg},
                         {"frames", calibration.used}};
  if (!calibration.utc.empty()) json["calibration"]["utc"] = calibration.utc;
  writeWholeFile(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n", FileAccess::by_umask);
}

}  // namespace facenav::coil_tracking
