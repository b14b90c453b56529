#pragma once
// Prepares a camera that is used for the first time: it adjusts itself to the light for a while, then its
// values are locked and stored with the rig.

#include "facenav/capture/camera_pair_source.h"
#include "facenav/capture/rig_store.h"

namespace facenav::steps {

/// Settles a camera in some two seconds; files have nothing to settle. Throws CameraError as
/// capture::openCamera and Camera::configure do.
capture::RigCamera settledCamera(const capture::CameraBackends& backends,
                                 const capture::CameraIdentity& identity, capture::CameraSettings settings);

/// Two running cameras, with the settings that they were locked at.
struct NewPair {
  capture::RigCamera left, right;
  std::unique_ptr<capture::CameraPairSource> source;
};
/// A CameraError that knows which of the two cameras it is about.
class PairError : public capture::CameraError {
 public:
  PairError(const capture::CameraError& error, bool is_left)
      : CameraError(error.fault(), error.what(), "", ""), is_left_(is_left) {}
  bool isLeft() const { return is_left_; }

 private:
  bool is_left_;
};

/// Opens a pair by names as capture::findCamera takes them. `settings`: the wanted size and rate. Throws
/// PairError if one of them cannot be used.
NewPair openNewPair(const capture::CameraBackends& backends, const std::string& left,
                    const std::string& right, const capture::CameraSettings& settings);

/// Effect of the calibration's error on a point `distance_mm` before the left camera; nothing if the
/// calibration has no errors stored.
std::optional<capture::RigUncertainty_mm> uncertaintyAt(const cameras::StereoRig& rig, double distance_mm);

}  // namespace facenav::steps
