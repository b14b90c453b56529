#pragma once
// Common input of all scripts, and small functions they share.

#include <functional>
#include <vector>

#include "head_motion.h"
#include "script.h"

namespace facenav::room {

inline constexpr double kAway_mm = 700.0;  // a patient this far aside is in neither image

struct Setting {
  ScenarioOptions options;
  RigidTransform<Room, Mri> seat;  // head pose before any motion
  Point<Mri> pivot, face_middle;
  RigidTransform<Mri, frames::Target> target;
  std::optional<RigidTransform<Mri, frames::Target>> second_target;  // of a second coil
  RigidTransform<Marker, Coil> marker_T_coil;
  int frames = 1;

  double time_s(double frame) const { return frame / options.frames_per_s; }
  /// Position of a frame in the recording: 0 at the first, 1 at the last.
  double part(double frame) const { return frames > 1 ? frame / (frames - 1) : 0.0; }
  /// The head turned by a rotation vector (deg, Room axes) about its pivot and shifted (mm).
  RigidTransform<Room, Mri> moved(const Eigen::Matrix<double, 6, 1>& by) const;
  Cast headMovedBy(const Eigen::Matrix<double, 6, 1>& by) const;
  HeadMotion motion(MotionSize size) const;
  /// Middle of the seated face, Room mm.
  Eigen::Vector3d face_mm() const { return (seat * face_middle).mm; }
};

/// The consecutive parts of a script: each part lasts until its share (0..1) of the whole.
class Parts {
 public:
  struct Part {
    double until;
    const char* label;
  };
  struct Place {
    const char* label;
    double inside;  // 0 at the part's start, 1 at its end
  };
  /// Takes the parts in order; the last one must end beyond 1.
  explicit Parts(std::vector<Part> parts) : parts_(std::move(parts)) {}
  Place at(double share) const;

 private:
  std::vector<Part> parts_;
};

using MomentOf = std::function<Moment(double frame)>;  // fractional frames are allowed

/// Smooth step 0..1 with zero speed and acceleration at both ends.
double ease(double x);

// script_motions.cpp: the head moves.
MomentOf stillScript(const Setting& setting);
MomentOf protractorScript(const Setting& setting);
MomentOf freeMotionScript(const Setting& setting);
MomentOf treatmentScript(Setting setting);
MomentOf turningScript(const Setting& setting);
// script_sensors.cpp: faults of ordinary cameras.
MomentOf fastCoilScript(const Setting& setting);
MomentOf glassesScript(const Setting& setting);
/// script_drift.cpp: the right camera moves on its mount.
MomentOf driftScript(const Setting& setting);
// script_disturbances.cpp: disturbances of a treatment room.
MomentOf occlusionScript(const Setting& setting);
MomentOf talkingScript(const Setting& setting);
MomentOf lightingScript(const Setting& setting);
MomentOf lostScript(const Setting& setting);
MomentOf coilSweepScript(const Setting& setting);
// script_people.cpp: what patients wear, and other persons.
MomentOf glintScript(const Setting& setting);
MomentOf maskScript(const Setting& setting);
MomentOf otherFaceScript(const Setting& setting);

// script_grimaces.cpp: changes of face, light and cameras between two moments.
MomentOf grimaceScript(const Setting& setting);
MomentOf returnsScript(const Setting& setting);
MomentOf outOfStepScript(const Setting& setting);
/// Expression of the options' capture_grimace; the seed selects its kind.
Expression captureExpression(const ScenarioOptions& options);

// script_moments.cpp: a real person in front of real cameras.
MomentOf momentsScript(const Setting& setting);

/// The patient's small movements at rest: rotation vector (deg) and shift (mm).
Eigen::Matrix<double, 6, 1> sway(double time_s, double scale);
/// Rises from 0 to 1 at the middle and falls back.
double hill(double x);

}  // namespace facenav::room
