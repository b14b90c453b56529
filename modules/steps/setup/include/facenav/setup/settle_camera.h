#pragma once
// A camera that is used for the first time: it adjusts itself to the light for a while, then it is locked at
// what it found. The values are kept with the rig.

#include "facenav/capture/camera_pair_source.h"
#include "facenav/capture/rig_store.h"

namespace facenav::steps {

/// Takes some two seconds. Throws CameraError as capture::openCamera and Camera::configure do.
capture::RigCamera settledCamera(const capture::CameraBackends& backends,
                                 const capture::CameraIdentity& identity, capture::CameraSettings settings);

/// Two cameras that run, with the settings that they were locked at.
struct NewPair {
  capture::RigCamera left, right;
  std::unique_ptr<capture::CameraPairSource> source;
};
/// By names as capture::findCamera takes them. `settings` holds the wanted size and rate.
NewPair openNewPair(const capture::CameraBackends& backends, const std::string& left,
                    const std::string& right, const capture::CameraSettings& settings);

/// Effect of the calibration's error on a point `distance_mm` before the left camera; nothing where the
/// calibration states no errors.
std::optional<capture::RigUncertainty_mm> uncertaintyAt(const cameras::StereoRig& rig, double distance_mm);

}  // namespace facenav::steps
