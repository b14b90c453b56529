#pragma once
// RigStart: a kept rig is verified each time its cameras open: its adjustments and sizes, and from the
// first seconds of pictures whether the calibration still holds. The coil's marker shows every motion of a
// camera. A face shows a nod; it shows a roll only away from the picture's middle, and no sideways turn. In:
// NamedRig, opened cameras, stereo frames. Out: one line for the user and for the rig's folder. Used by
// verified_cameras.h, so by every step that opens a kept rig.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/capture/rig_store.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/face/face_landmarks.h"
#include "facenav/health/verify_rig.h"

namespace facenav::steps {

/// What was found at one start.
struct RigStart {
  enum class By { nothing, face, marker, both };

  health::RigState state = health::RigState::unclear;
  By by = By::nothing;                // what was seen well enough
  std::string geometry;               // what was found of the calibration, with numbers
  std::vector<std::string> differs;   // adjustments that are not as kept, one line each
  std::vector<std::string> restored;  // that were not, and are again
  /// An earlier check that found a fault, which nothing has cleared since.
  std::optional<capture::RigCheckNote> earlier;

  /// Guidance and alignment with these cameras may be wrong: they are withheld until the rig is repaired.
  bool isWithheld() const;
  /// One line, without what to do about a fault.
  std::string words() const;
};

/// What judges the pictures.
struct RigStartMethods {
  std::shared_ptr<const face::FaceDetector> face_detector;   // null: no face is looked for
  std::unique_ptr<coil_tracking::CoilTracker> coil_tracker;  // null: no marker is looked for
  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();
};

class RigStartCheck {
 public:
  /// A `last_check` of the rig that found a fault stays in force until the marker shows that the calibration
  /// holds: a face cannot show that a camera no longer looks sideways.
  RigStartCheck(const capture::NamedRig& rig, RigStartMethods methods);
  ~RigStartCheck();
  RigStartCheck(RigStartCheck&&) noexcept;

  /// How the cameras stand after they were opened (capture::changedSettings, restoredSettings).
  void noteSettings(std::vector<std::string> differs, std::vector<std::string> restored);
  /// One frame of the rig's size, in the order of their times. Takes milliseconds; a second for each of the
  /// few frames in which a face is measured. Throws Error: the pictures have another size.
  void add(const cameras::StereoFrame& frame);
  RigStart result() const;
  /// Further frames would change nothing.
  bool isDone() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::steps
