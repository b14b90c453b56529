#include "facenav/setup/settle_camera.h"

#include "facenav/cameras/head_effect.h"

namespace facenav::steps {
namespace {

constexpr double kSettle_s = 1.5;  // time in which a camera's automatic exposure settles

/// Stores the camera's current values, so that they are the same at each start.
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

}  // namespace

capture::RigCamera settledCamera(const capture::CameraBackends& backends,
                                 const capture::CameraIdentity& identity, capture::CameraSettings settings) {
  const auto camera = capture::openCamera(backends, identity);
  if (camera->isFromFiles()) {
    camera->configure(settings);
    return {identity, settings};
  }
  capture::CameraSettings adjusting = settings;
  adjusting.is_adjusting = true;
  camera->configure(adjusting);
  camera->start();
  for (const double until_s = Timestamp::now().s + kSettle_s; Timestamp::now().s < until_s;)
    camera->next(0.1);
  keepLocked(camera->configure(settings), settings);
  return {identity, settings};
}

namespace {

capture::RigCamera settledSide(const capture::CameraBackends& backends,
                               const std::vector<capture::FoundCamera>& found, const std::string& name,
                               const capture::CameraSettings& settings, bool is_left) {
  try {
    return settledCamera(backends, capture::findCamera(found, name), settings);
  } catch (const capture::CameraError& error) {
    throw PairError(error, is_left);
  } catch (const Error& error) {
    throw PairError({capture::CameraFault::refused, error.what(), "", ""}, is_left);
  }
}

}  // namespace

NewPair openNewPair(const capture::CameraBackends& backends, const std::string& left,
                    const std::string& right, const capture::CameraSettings& settings) {
  const auto found = capture::listCameras(backends);
  NewPair pair;
  pair.left = settledSide(backends, found, left, settings, true);
  pair.right = settledSide(backends, found, right, settings, false);
  cameras::StereoRig size;  // only the size is known yet
  size.width_px = settings.width_px;
  size.height_px = settings.height_px;
  pair.source = capture::openCameraPair(size, capture::openCamera(backends, pair.left.identity),
                                        capture::openCamera(backends, pair.right.identity),
                                        {pair.left.settings, pair.right.settings});
  return pair;
}

std::optional<capture::RigUncertainty_mm> uncertaintyAt(const cameras::StereoRig& rig, double distance_mm) {
  if (rig.covariance.empty()) return std::nullopt;
  return capture::RigUncertainty_mm{distance_mm, cameras::effectAtHead(rig, {0, 0, distance_mm}).point_mm};
}

}  // namespace facenav::steps
