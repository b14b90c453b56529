#include "facenav/measured_face/unmoved_cameras.h"

#include <cmath>

#include "facenav/health/face_offset.h"
#include "facenav/health/pair_diagnosis.h"
#include "facenav/health/rig_error.h"
#include "facenav/health/rig_monitor.h"
#include "facenav/health/surface_matches.h"

namespace facenav::measured_face {
namespace {

constexpr double kWrong_mm = 3;  // error of a wrong pose

/// True if the face lies off its lines so far that its depth is likely wrong, by whatever cause.
bool meansWrongDepth(const cameras::StereoRig& rig, const health::FaceOffset& offset) {
  return offset.isSignificant() &&
         std::abs(offset.median_px) > health::offsetOfDepthError_px(rig, kWrong_mm, offset.depth_mm);
}

}  // namespace

void requireUnmovedCameras(const cameras::StereoRig& rig, const cameras::StereoFrame& measured,
                           const cameras::StereoFrame& plain, const stereo::FaceCloud& face,
                           const FaceInSpace& landmarks) {
  const auto face_px = landmarks.left ? face::outlineOf(*landmarks.left) : health::outlineOf(face.left_px);
  health::RigMonitor monitor(rig);
  const auto matches = health::matchSurface(rig, measured, face.cloud, face.left_px, face_px);
  monitor.add(matches);
  const auto estimate = monitor.estimate();
  const auto offset = health::faceOffset(rig, matches);
  if (!estimate.hasMoved() && !offset.isSignificant()) return;
  const auto diagnosis = health::diagnosePair(rig, plain, face_px);
  if (diagnosis.isFault()) throw health::RigError(diagnosis.verdict(), "not aligned: ");
  const bool is_wrong = meansWrongDepth(rig, offset);
  if (is_wrong || (estimate.hasMoved() && diagnosis.state != health::RigState::holds))
    throw health::RigError(
        health::camerasDisagree(is_wrong ? std::abs(offset.median_px) : estimate.epipolar_px),
        "not aligned: ");
}

}  // namespace facenav::measured_face
