#pragma once
// Stereo pairs of a printed chessboard with exact truth, and rigs that differ from their calibration. The
// program must compile unit/track/coil_tracking/coil_scene.cpp.

#include <opencv2/imgcodecs.hpp>

#include "facenav/cameras/chessboard.h"
#include "facenav/geometry/rotation.h"
#include "unit/track/coil_tracking/coil_scene.h"

namespace facenav::testing {

inline const cameras::Board kPrintedBoard{9, 6, 20.0};
inline const char* const kPrintedBoardOptions = "--board 9x6 --square 20";

/// kPrintedBoard as a print of 10 x 10 squares, its last three rows white.
inline coil_tracking::testing::PlacedPrint placedBoard(const RigidTransform<Camera, Marker>& pose) {
  coil_tracking::testing::Print print(10, 10, 1.0F);
  for (int y = 0; y < 7; ++y)
    for (int x = 0; x < 10; ++x) print(y, x) = float((x + y) % 2);
  return {print, 200.0, pose, 1.0};
}

/// The board in one of several positions before the rig.
inline cameras::StereoFrame boardFrame(const cameras::StereoRig& rig, int position) {
  static const double kDistance_mm[] = {600, 560, 660}, kTilt_deg[] = {20, 30, 15},
                      kAxis_deg[] = {10, 100, 220};
  const int i = position % 3;
  const auto pose = coil_tracking::testing::markerPose(kDistance_mm[i], kTilt_deg[i], kAxis_deg[i], 5.0 * i,
                                                       {15.0 * (i - 1), 20.0 - 8.0 * i});
  coil_tracking::testing::SceneOptions options;
  options.has_clutter = false;
  options.seed = unsigned(position + 1);
  auto frame = coil_tracking::testing::renderMarkers(rig, {placedBoard(pose)}, options);
  frame.number = position;
  return frame;
}

/// Turns the right camera on its mount, about its own axes (x right, y down, z forward).
inline cameras::StereoRig turnedRight(cameras::StereoRig rig, const Eigen::Vector3d& turn_rad) {
  const Eigen::Matrix3d turn = expRotation(turn_rad);
  rig.right_T_left = RigidTransform<RightCamera, Camera>(
      Eigen::Quaterniond(turn * rig.right_T_left.rotation()), turn * rig.right_T_left.translation_mm());
  return rig;
}

}  // namespace facenav::testing
