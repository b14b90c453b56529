// facenav rig new: two cameras, their locked settings and their calibration under a name.

#include <cstdio>

#include "commands/rig_steps.h"
#include "facenav/cameras/calibrate.h"
#include "facenav/capture/calibration_images.h"
#include "facenav/core/log.h"

namespace facenav::app {
namespace {

constexpr double kSettle_s = 1.5;  // a camera's automatic exposure has settled by then
constexpr double kTrial_s = 1.0;   // of the pair, for what must be said about it

cameras::StereoRig calibrated(const RigRequest& request, Context& context) {
  if (!request.calibration.empty()) return cameras::readRig(request.calibration);
  const auto board = boardOf(request);
  if (!board || request.left.empty() || request.right.empty())
    throw Error("the calibration is missing", "",
                "give --calibration stereo.yml, or --board, --square, --left and --right pictures");
  const auto result = cameras::calibrate(capture::readCalibrationImages(request.left, request.right), *board,
                                         context.monitor);
  for (const auto& warning : result.warnings) logWarning(warning);
  return result.rig;
}

std::optional<capture::RigUncertainty_mm> uncertaintyAt(const cameras::StereoRig& rig, double distance_mm) {
  if (rig.covariance.empty()) return std::nullopt;
  return capture::RigUncertainty_mm{distance_mm, cameras::effectAtHead(rig, {0, 0, distance_mm}).point_mm};
}

/// The values that the cameras have now: kept, so that they are the same at each start.
void keepLocked(const capture::CameraState& state, capture::CameraSettings& settings) {
  const auto keep = [&](const char* name, std::optional<double>& value) {
    for (const auto& control : state.controls)
      if (control.name == name && control.lock == capture::ControlState::Lock::locked) value = control.actual;
  };
  keep("exposure", settings.exposure_ms);
  keep("gain", settings.gain);
  keep("focus", settings.focus);
  keep("white balance", settings.white_balance_k);
  if (state.format != "stream") settings.format = state.format;
}

/// The camera adjusts itself to the light for a while; then it is locked at what it found.
capture::RigCamera settled(const capture::CameraBackends& backends, const capture::CameraIdentity& identity,
                           capture::CameraSettings settings) {
  const auto camera = capture::openCamera(backends, identity);
  capture::CameraSettings adjusting = settings;
  adjusting.is_adjusting = true;
  camera->configure(adjusting);
  camera->start();
  for (const double until_s = Timestamp::now().s + kSettle_s; Timestamp::now().s < until_s;)
    camera->next(0.1);
  keepLocked(camera->configure(settings), settings);
  return {identity, settings};
}

void addCamerasTo(capture::NamedRig& rig, const RigRequest& request, const Context& context) {
  const auto& backends = context.registrations.cameras;
  const auto found = capture::listCameras(backends);
  capture::CameraSettings settings = request.settings;
  settings.width_px = rig.rig.width_px;
  settings.height_px = rig.rig.height_px;
  rig.left = settled(backends, capture::findCamera(found, request.left_camera), settings);
  rig.right = settled(backends, capture::findCamera(found, request.right_camera), settings);
  const auto source = capture::openRig(backends, rig);
  for (const double until_s = Timestamp::now().s + kTrial_s; Timestamp::now().s < until_s;)
    if (!source->next()) break;
  for (const auto& words : source->cautions()) logWarning(words);
}

}  // namespace

void makeRig(const RigRequest& request, Context& context) {
  if (request.left_camera.empty() != request.right_camera.empty())
    throw Error("one of the two cameras is missing", "", "give --left-camera and --right-camera, or neither");
  const capture::RigStore store(request.rigs);
  if (!request.is_replacing && std::filesystem::exists(store.folderOf(request.name)))
    throw Error("there is a rig of this name", store.folderOf(request.name).string(),
                "choose another, or give --replace");
  capture::NamedRig rig;
  rig.name = request.name;
  rig.created_utc = rigUtcNow();
  rig.rig = calibrated(request, context);
  rig.uncertainty = uncertaintyAt(rig.rig, request.distance_mm);
  if (!request.left_camera.empty()) addCamerasTo(rig, request, context);
  store.write(rig, request.is_replacing ? Existing::replace : Existing::refuse);
  std::printf("%s: %d x %d px, %.1f mm apart, %s: %s\n", rig.name.c_str(), rig.rig.width_px,
              rig.rig.height_px, rig.rig.baseline_mm(), uncertaintyInWords(rig).c_str(),
              store.folderOf(rig.name).c_str());
  if (!rig.left)
    logWarning(
        "the rig knows no cameras; with --left-camera and --right-camera it keeps which two, and their "
        "settings");
}

}  // namespace facenav::app
