#pragma once
// Withheld: the one reason why poses are not shown although they may have been measured. A value: the words
// for the banner, the log and poses.csv are made from it where they are needed.

#include <string>

#include "facenav/health/rig_state.h"

namespace facenav::monitoring {

struct Withheld {
  enum class Source { cameras, drift, registration_check, person };
  enum class Reason {
    camera_fault,         // `rig` says which
    drifted,              // the face is no longer where tracking places it
    not_checked,          // the registration must pass a check first
    registration_failed,  // its last check failed
    judged_wrong,         // a person saw that the alignment is wrong
  };
  Reason reason = Reason::camera_fault;
  Source source = Source::cameras;
  health::RigVerdict rig = {};            // source cameras
  double shift_mm = 0.0, turn_deg = 0.0;  // registration_failed: how far the face is off

  /// A fault of the cameras makes the coil's pose wrong as well; every other reason is about the head alone.
  bool isOfCameras() const { return source == Source::cameras; }
  /// It lasts until the registration passes a check, or until the head is aligned again.
  bool isOfAlignment() const { return source == Source::registration_check || source == Source::person; }
};

/// For the banner, with what to do: "REGISTRATION FAILED: the face is 2.1 mm and 0.3 deg off, align again".
std::string bannerOf(const Withheld& withheld);
/// For the banner, of a fault of the cameras alone: "CAMERAS MOVED: calibrate them again". Empty: no fault.
std::string bannerOf(health::RigState state);
/// For poses.csv: "cameras_moved", "other_rig", "camera_away", "swapped", "out_of_step", "drift",
/// "not_checked".
std::string wordOf(const Withheld& withheld);

}  // namespace facenav::monitoring
