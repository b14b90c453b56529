#pragma once
// Withheld: the one reason why measured poses are not shown. A value: banner, log and poses.csv derive their
// words from it.

#include <string>

#include "facenav/health/rig_state.h"

namespace facenav::monitoring {

struct Withheld {
  enum class Source { cameras, drift, registration_check, person };
  enum class Reason {
    camera_fault,         // details in `rig`
    drifted,              // the face is no longer where tracking places it
    not_checked,          // the registration must pass a check first
    registration_failed,  // its last check failed
    judged_wrong,         // a person saw that the alignment is wrong
  };
  Reason reason = Reason::camera_fault;
  Source source = Source::cameras;
  health::RigVerdict rig = {};            // source cameras
  double shift_mm = 0.0, turn_deg = 0.0;  // registration_failed: how far the face is off

  /// True for a fault of the cameras: it makes the coil's pose wrong as well. Every other reason concerns the
  /// head alone.
  bool isOfCameras() const { return source == Source::cameras; }
  /// True if the reason lasts until the registration passes a check, or until the head is aligned again.
  bool isOfAlignment() const { return source == Source::registration_check || source == Source::person; }
};

/// Text for the banner, with what to do: "REGISTRATION FAILED: the face is 2.1 mm and 0.3 deg off, align
/// again".
std::string bannerOf(const Withheld& withheld);
/// Text for the banner, for a fault of the cameras alone: "CAMERAS MOVED: calibrate them again". Empty: no
/// fault.
std::string bannerOf(health::RigState state);
/// Word for poses.csv: "cameras_moved", "other_rig", "camera_away", "swapped", "out_of_step", "drift",
/// "not_checked".
std::string wordOf(const Withheld& withheld);

}  // namespace facenav::monitoring
