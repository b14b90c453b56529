#pragma once
// RigStart: verifies a stored rig each time its cameras open: its adjustments and sizes, and from the first
// seconds of pictures whether the calibration is still valid. The coil's marker shows every motion of a
// camera. A face shows pitch; it shows roll only away from the picture's middle, and no sideways turn. In:
// NamedRig, opened cameras, stereo frames. Out: one line for the user and for the rig's folder. Used by
// verified_cameras.h, so by every step that opens a stored rig.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/capture/rig_store.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/health/verify_rig.h"

namespace facenav::steps {

/// Findings at one start.
struct RigStart {
  enum class By { nothing, face, marker, both };

  health::RigState state = health::RigState::unclear;
  By by = By::nothing;                // the object that was seen well enough
  std::string geometry;               // finding on the calibration, with numbers
  std::vector<std::string> differs;   // adjustments that differ from the stored ones, one line each
  std::vector<std::string> restored;  // adjustments that differed and were restored
  /// Earlier check that found a fault that is still in force.
  std::optional<capture::RigCheckNote> earlier;

  /// True if guidance and alignment with these cameras may be wrong: they are withheld until the rig is
  /// repaired.
  bool isWithheld() const;
  /// One line, without the advice on a fault.
  std::string words() const;
};

/// Methods that judge the pictures.
struct RigStartMethods {
  std::shared_ptr<const face::FaceDetector> face_detector;   // null: no search for a face
  std::unique_ptr<coil_tracking::CoilTracker> coil_tracker;  // null: no search for a marker
  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();
};

class RigStartCheck {
 public:
  /// Starts a check. A `last_check` of the rig that found a fault stays in force until the marker shows that
  /// the calibration is valid, because a face cannot show that a camera turned sideways.
  RigStartCheck(const capture::NamedRig& rig, RigStartMethods methods);
  ~RigStartCheck();
  RigStartCheck(RigStartCheck&&) noexcept;

  /// Notes the cameras' settings after opening (capture::changedSettings, restoredSettings).
  void noteSettings(std::vector<std::string> differs, std::vector<std::string> restored);
  /// Adds a frame of the rig's size, in the order of their times. Takes milliseconds; a second for each of
  /// the few frames in which a face is measured. Throws Error: the pictures have another size.
  void add(const cameras::StereoFrame& frame);
  RigStart result() const;
  /// True if further frames would change nothing.
  bool isDone() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::steps
