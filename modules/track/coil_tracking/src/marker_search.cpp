#include "marker_search.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "facenav/core/robust_statistics.h"
#include "facenav/health/rig_monitor.h"
#include "marker_fit.h"

namespace facenav::coil_tracking {
namespace {

// Size limits relative to the calibration. Corners found by a search are off by up to 1 px: 2 % in size.
// Beyond the upper limit it is another object, or the pictures are exchanged.
constexpr double kOtherSize = 0.025, kMostOtherSize = 0.2;
constexpr double kOtherRow_px = 3.0;

std::array<Eigen::Vector3d, 4> cornersInMarker_mm(double size_mm) {
  const double h = size_mm / 2;
  return {Eigen::Vector3d(-h, -h, 0), Eigen::Vector3d(h, -h, 0), Eigen::Vector3d(h, h, 0),
          Eigen::Vector3d(-h, h, 0)};
}

/// Pitch of the right camera that moves the image of `p_mm` by `row_px` across the epipolar lines.
double pitchFor_rad(const cameras::StereoRig& rig, const Eigen::Vector3d& p_mm, double row_px) {
  constexpr double kSmall_rad = 1e-3;
  FitState pitched;
  pitched.pitch_rad = kSmall_rad;
  const Eigen::Vector3d in_right_mm = rightFromLeft(rig, pitched, p_mm) * p_mm;
  return kSmall_rad * row_px /
         cameras::epipolarResidual_px(rig, cameras::project(rig.left, p_mm),
                                      cameras::project(rig.right, in_right_mm));
}

}  // namespace

std::optional<Quad> cornersInImage(const CoilSetup& setup, std::size_t marker,
                                   const Eigen::Isometry3d& camera_T_coil, bool is_left,
                                   const Eigen::Isometry3d& right_T_left) {
  const cameras::StereoRig& rig = setup.rig;
  const Eigen::Isometry3d camera_T_marker =
      camera_T_coil * setup.coil.markers[marker].coil_T_marker.isometry();
  const Eigen::Isometry3d view = is_left ? camera_T_marker : right_T_left * camera_T_marker;
  if (view.linear().col(2).dot(view.translation()) <= 0) return std::nullopt;
  Quad quad;
  const auto corners_mm = cornersInMarker_mm(setup.coil.markers[marker].size_mm);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d p_mm = view * corners_mm[i];
    if (p_mm.z() < kLeastDepth_mm) return std::nullopt;
    quad[i] = cameras::project(is_left ? rig.left : rig.right, p_mm);
    if (!(quad[i].x() >= 0 && quad[i].y() >= 0 && quad[i].x() < rig.width_px - 1 &&
          quad[i].y() < rig.height_px - 1))
      return std::nullopt;
  }
  return quad;
}

std::vector<CoilToCamera> posesFromOneImage(const CoilSetup& setup, const MarkerDetection& seen,
                                            bool is_left) {
  std::vector<cv::Point3d> model;
  std::vector<cv::Point2d> image;
  for (const auto& p_mm : cornersInMarker_mm(setup.coil.markers[seen.marker].size_mm))
    model.emplace_back(p_mm.x(), p_mm.y(), p_mm.z());
  for (const auto& corner : seen.corners) {
    const Eigen::Vector2d n = cameras::undistort(is_left ? setup.rig.left : setup.rig.right, corner);
    image.emplace_back(n.x(), n.y());
  }
  std::vector<cv::Vec3d> rotations, translations;
  cv::solvePnPGeneric(model, image, cv::Matx33d::eye(), cv::noArray(), rotations, translations, false,
                      cv::SOLVEPNP_IPPE);
  std::vector<CoilToCamera> poses;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    Eigen::Isometry3d view_T_marker = Eigen::Isometry3d::Identity();
    view_T_marker.linear() = expRotation({rotations[i][0], rotations[i][1], rotations[i][2]});
    view_T_marker.translation() << translations[i][0], translations[i][1], translations[i][2];
    if (!view_T_marker.matrix().allFinite()) continue;
    const Eigen::Isometry3d camera_T_view =
        is_left ? Eigen::Isometry3d::Identity() : setup.rig.right_T_left.isometry().inverse();
    poses.push_back(RigidTransform<Camera, Marker>::fromIsometry(camera_T_view * view_T_marker) *
                    setup.coil.markers[seen.marker].coil_T_marker.inverse());
  }
  return poses;
}

std::vector<FitState> statesFromBothImages(const CoilSetup& setup, const MarkerDetection& seen, bool is_left,
                                           const Quad& in_other, const std::vector<CoilToCamera>& poses) {
  const cameras::StereoRig& rig = setup.rig;
  const Quad &left_px = is_left ? seen.corners : in_other, &right_px = is_left ? in_other : seen.corners;
  Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
  double row_px = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    middle_mm += 0.25 * cameras::triangulate(rig, left_px[i], right_px[i]).mm;
    row_px += 0.25 * cameras::epipolarResidual_px(rig, left_px[i], right_px[i]);
  }
  if (!(middle_mm.z() > kLeastDepth_mm)) return {};
  const double pitch_rad = pitchFor_rad(rig, middle_mm, row_px);
  if (!(std::abs(pitch_rad) < kSignificant * kTurnSigma_rad)) return {};
  const Eigen::Vector3d eye_mm =
      is_left ? Eigen::Vector3d(0, 0, 0) : Eigen::Vector3d(rig.right_T_left.inverse().translation_mm());
  const Eigen::Vector3d centre_in_coil_mm = setup.coil.markers[seen.marker].coil_T_marker.translation_mm();
  std::vector<FitState> states;
  for (const CoilToCamera& pose : poses) {
    // A print that is larger and farther in proportion looks the same to this image.
    const Eigen::Vector3d at_mm = pose.isometry() * centre_in_coil_mm - eye_mm;
    FitState state;
    state.size_factor = (middle_mm - eye_mm).norm() / at_mm.norm();
    const double other_size = std::abs(state.size_factor - 1.0);
    if (other_size > kMostOtherSize || (other_size < kOtherSize && std::abs(row_px) < kOtherRow_px)) continue;
    state.camera_T_coil = pose.isometry();
    state.camera_T_coil.translation() += (state.size_factor - 1.0) * at_mm;
    state.pitch_rad = pitch_rad;
    states.push_back(state);
  }
  return states;
}

std::vector<std::size_t> markersInView(const CoilSetup& setup, const CoilToCamera& camera_T_coil) {
  std::vector<std::size_t> markers;
  const auto& right_T_left = setup.rig.right_T_left.isometry();
  for (std::size_t marker = 0; marker < setup.patterns.size(); ++marker)
    if (cornersInImage(setup, marker, camera_T_coil.isometry(), true, right_T_left) &&
        cornersInImage(setup, marker, camera_T_coil.isometry(), false, right_T_left))
      markers.push_back(marker);
  return markers;
}

bool isReadInBoth(const CoilSetup& setup, const cameras::StereoFrame& frame, std::size_t marker,
                  const Eigen::Isometry3d& camera_T_coil, const Eigen::Isometry3d& right_T_left) {
  const auto left = cornersInImage(setup, marker, camera_T_coil, true, right_T_left);
  const auto right = cornersInImage(setup, marker, camera_T_coil, false, right_T_left);
  return left && right && showsUpright(frame.left, *left, setup.patterns[marker]) &&
         showsUpright(frame.right, *right, setup.patterns[marker]);
}

int searchReach_px(const CoilSetup& setup, const std::vector<std::size_t>& markers,
                   const CoilToCamera& camera_T_coil) {
  double least_px = 10.0;
  for (const std::size_t marker : markers)
    for (const bool is_left : {true, false}) {
      const auto quad =
          cornersInImage(setup, marker, camera_T_coil.isometry(), is_left, setup.rig.right_T_left.isometry());
      if (!quad) continue;
      const Eigen::Vector2d across = (*quad)[2] - (*quad)[0], other = (*quad)[3] - (*quad)[1];
      const double area_px2 = 0.5 * std::abs(across.x() * other.y() - across.y() * other.x());
      const double longest_px = std::max(across.norm(), other.norm()) / std::sqrt(2.0);
      const int cells = setup.patterns[marker].isBinary() ? setup.patterns[marker].cellsPerSide() : 4;
      least_px = std::min(least_px, area_px2 / longest_px / cells);
    }
  return std::clamp(int(1.2 * least_px), 2, 12);
}

}  // namespace facenav::coil_tracking
