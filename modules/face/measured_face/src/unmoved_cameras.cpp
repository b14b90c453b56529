#include "facenav/measured_face/unmoved_cameras.h"

#include "facenav/core/number_text.h"
#include "facenav/health/pair_diagnosis.h"
#include "facenav/health/rig_error.h"
#include "facenav/health/rig_monitor.h"
#include "facenav/health/surface_matches.h"
#include "facenav/measured_face/projected_dots.h"

namespace facenav::measured_face {
namespace {

constexpr double kClearStatistic = 40;  // as in health::RigHealth: twice the monitor's own threshold

}  // namespace

void requireUnmovedCameras(const cameras::StereoRig& rig, const cameras::StereoFrame& measured,
                           const cameras::StereoFrame& plain, const stereo::FaceCloud& face,
                           const FaceInSpace& landmarks) {
  health::RigMonitor monitor(rig);
  monitor.add(health::matchSurface(rig, measured, face.cloud, face.left_px));
  const auto estimate = monitor.estimate();
  if (!estimate.hasMoved()) return;
  const auto face_px = landmarks.left ? face::outlineOf(*landmarks.left) : health::outlineOf(face.left_px);
  const auto diagnosis = health::diagnosePair(rig, plain, face_px);
  if (diagnosis.isFault()) throw health::RigError(diagnosis, "not aligned: ");
  // If plain skin disagrees a little but the face in the plain pair fits, the cameras did not move.
  const bool is_clear = estimate.statistic > kClearStatistic && showsDots({measured, plain});
  if (is_clear)
    throw health::RigError("not aligned: " + estimate.verdict().words(), {}, "'facenav calibrate'");
  if (diagnosis.state != health::RigState::holds)
    throw health::RigError(
        "not aligned: " +
            formatted("the pictures do not fit the calibration (%.2f px across the epipolar lines): "
                      "a camera has moved since, or they were taken at two moments",
                      estimate.epipolar_px),
        {}, "trigger both cameras together; if they are, calibrate again");
}

}  // namespace facenav::measured_face
