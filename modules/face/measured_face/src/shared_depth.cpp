#include "facenav/measured_face/shared_depth.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "facenav/cameras/rig_uncertainty.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/stereo/shared_error.h"

namespace facenav::measured_face {
namespace {

// Standard errors of a disparity shared by the whole face: by matching, and by a good calibration without a
// covariance. Larger is safe.
constexpr double kMatching_px = 0.01, kGoodCalibration_px = 0.02;

Eigen::Vector3d medianOf(const PointCloud<Camera>& face) {
  Eigen::Vector3d middle;
  std::vector<double> values(face.size());
  for (int a = 0; a < 3; ++a) {
    std::transform(face.points_mm.begin(), face.points_mm.end(), values.begin(),
                   [a](const Eigen::Vector3d& p) { return p[a]; });
    middle[a] = upperMedian(values);
  }
  return middle;
}

/// Standard error of the depth of two given pixels, from the calibration's covariance: root sum of squares of
/// the changes by one standard deviation of each parameter.
double byCalibration_mm(const cameras::StereoRig& rig, const Eigen::Vector3d& p_mm) {
  const Eigen::Vector2d left_px = cameras::project(rig.left, p_mm),
                        right_px = cameras::project(rig.right, rig.right_T_left.isometry() * p_mm);
  const double as_is_mm = cameras::triangulate(rig, left_px, right_px).mm.norm();
  double squares = 0;
  for (const cameras::StereoRig& other : cameras::uncertaintyOf(rig).one_sigma)
    squares += std::pow(cameras::triangulate(other, left_px, right_px).mm.norm() - as_is_mm, 2);
  return std::sqrt(squares);
}

}  // namespace

double sharedDepthSigma_mm(const cameras::StereoRig& rig, const PointCloud<Camera>& face) {
  if (face.empty()) return 0.0;
  const Eigen::Vector3d middle = medianOf(face);
  const double mm_per_px =
      middle.z() * middle.z() / (rig.left.k(0, 0) * rig.right_T_left.translation_mm().norm());
  if (rig.covariance.empty()) return kGoodCalibration_px * mm_per_px;
  return std::hypot(kMatching_px * mm_per_px, byCalibration_mm(rig, middle));
}

namespace {

/// Root mean square of the predicted deviations.
double statedDeviation_mm(const stereo::FaceCloud& face) {
  double squares = 0;
  for (const float sigma_mm : face.sigma_mm) squares += double(sigma_mm) * double(sigma_mm);
  return face.sigma_mm.empty() ? 0.0 : std::sqrt(squares / double(face.sigma_mm.size()));
}

}  // namespace

FaceError faceErrorOf(const cameras::StereoRig& rig, const stereo::FaceCloud& face) {
  const auto& shared = settingsOf<stereo::SharedError>();
  const double stated_mm = statedDeviation_mm(face);
  return {std::hypot(sharedDepthSigma_mm(rig, face.cloud), shared.whole * stated_mm),
          {shared.smooth * stated_mm, shared.reach_mm},
          stated_mm};
}

}  // namespace facenav::measured_face
