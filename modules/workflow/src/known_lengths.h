#pragma once
// What a marker of known size says about the right camera: a camera that turned sideways since the
// calibration measures every length too long or too short, as it measures every distance.

#include <optional>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/registration/aligner.h"

namespace facenav::workflow {

/// A length, as both cameras measure it over its true one, with the standard error of that ratio.
struct LengthSeen {
  Point<Camera> at;
  double ratio = 1.0, sigma = 0.0;
};

/// The coil's marker in a still pair. Nothing where it is not seen well in both pictures. The error holds
/// that of the print, of the pictures and of the calibration.
std::optional<LengthSeen> markerLength(const cameras::StereoRig& rig, const cameras::StereoFrame& pair,
                                       const coil_tracking::CoilModel& coil,
                                       coil_tracking::CoilTracker& tracker);

/// The turn of the right camera that explains it.
registration::CameraTurn turnBy(const LengthSeen& length, const registration::TurnableCamera& right);

}  // namespace facenav::workflow
