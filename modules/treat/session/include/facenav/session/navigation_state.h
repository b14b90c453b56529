#pragma once
// NavigationState: everything known at one frame, immutable once published. The window, the recorder and the
// tables read it. Poses in Camera (mm). A lost pose has no value (Tracked), and guidance is lost with it.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/timestamp.h"
#include "facenav/core/tracked.h"
#include "facenav/guidance/coil_gap.h"
#include "facenav/guidance/guidance.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/health/camera_drift.h"
#include "facenav/monitoring/registration_check.h"
#include "facenav/monitoring/withheld.h"

namespace facenav::session {

/// The chosen target with the alignment's predicted error there (mm, 0: unknown): standard error, and the
/// bound that 95 of 100 alignments keep, which is what people are shown.
struct ChosenTarget {
  guidance::Target target;
  double predicted_error_mm = 0.0, error_bound_mm = 0.0;
};

/// Largest bound (95 %) of the alignment at the target with which a coil can be on target. A coil 5 mm aside
/// gives a field that differs by 14 %. The total error of infrared navigators is about as large.
constexpr double kMostErrorBound_mm = 5.0;
/// Returns "alignment too uncertain (95 % within 8.0 mm, 5.0 allowed): align again" if nobody can tell with
/// it whether a coil is on target, else nothing.
std::string tooUncertainInWords(const ChosenTarget& chosen);

/// The second coil of a session at one frame; what it has in common with the first is in the state.
struct SecondCoil {
  std::string name;
  Tracked<coil_tracking::CoilPose> coil = Lost{LostReason::stale};
  Tracked<RigidTransform<Camera, Coil>> camera_T_coil = Lost{LostReason::stale};
  std::shared_ptr<const ChosenTarget> chosen;  // its own target; null: none
  std::optional<double> gap_mm;                // to the MRI's skin, by the poses; empty when lost
  guidance::GuidanceState guidance;
};

struct NavigationState {
  std::int64_t frame = -1;  // -1: none yet
  Timestamp captured;       // the source's clock
  Timestamp arrived;        // steady clock, when the frame arrived
  Timestamp taken;          // steady clock: capture of the frame; for a recording, its playback
  std::shared_ptr<const cameras::StereoFrame> images;

  Tracked<head_tracking::HeadPose> head = Lost{LostReason::stale};
  Tracked<coil_tracking::CoilPose> coil = Lost{LostReason::stale};
  Tracked<RigidTransform<Camera, Mri>> camera_T_mri = Lost{LostReason::stale};
  Tracked<RigidTransform<Camera, Coil>> camera_T_coil = Lost{LostReason::stale};

  cameras::ExposureOffset exposure_offset;      // between the cameras, as known at this frame
  std::array<double, 2> row_times_s{0.0, 0.0};  // rolling shutter, left and right camera; 0: none

  bool is_aligned = false;           // false: camera_T_mri is never tracked
  std::string target;                // name; empty: none chosen
  std::string coil_name;             // name of the tracked coil, to which the pose of `coil` belongs
  std::optional<SecondCoil> second;  // a second coil, by its own marker; empty: none
  bool is_head_served = false;       // the head's pose is another tracker's, not the cameras'
  bool is_coil_served = false;       // likewise the coil's
  /// Copy of the target as it was at this frame; null: none.
  std::shared_ptr<const ChosenTarget> chosen;
  /// Gap between the contact face and the head, by both poses and by the cameras; empty when lost.
  guidance::CoilGap gap;
  /// Tolerance that guidance used.
  guidance::Tolerance tolerance;
  guidance::GuidanceState guidance;

  double processing_ms = 0.0;  // head + coil + guidance
  double latency_ms = 0.0;     // from the frame's arrival to this state
  std::uint64_t dropped = 0;   // frames overwritten before they were tracked, since the start
  head_tracking::LossDetail head_detail =
      head_tracking::LossDetail::unknown;  // why the head is lost, as far as known
  /// Reason why poses are not shown: the head's, or both for a fault of the cameras.
  std::optional<monitoring::Withheld> withheld;
  /// Set if a camera moved on its mount and the poses are corrected for it.
  std::optional<health::CorrectedMotion> rig_correction;
  /// Newest check of the registration in this session; null: none was made.
  std::shared_ptr<const monitoring::RegistrationFinding> check;
  std::string failure;  // message of an Error that ended the session
};

/// Fault of the cameras that withholds every pose; empty: none.
std::optional<health::RigVerdict> rigFault(const NavigationState& state);
/// True if a camera is unplugged or silent; rigFault() returns which and why.
bool isCameraAway(const NavigationState& state);

/// Returns the state with every pose lost for `reason` and guidance blanked. The images stay and can be
/// shown.
NavigationState blanked(const NavigationState& state, LostReason reason);

/// Word for poses.csv, finer than the reason, why the head is lost ("covered", "drift", "cameras_moved").
/// Empty if the head is tracked or nothing more is known.
std::string lossWord(const NavigationState& state);

/// Message when something is lost, head first: "FACE HIDDEN: move the coil or hand aside". Empty when both
/// are tracked.
std::string lossInWords(const NavigationState& state);

/// Message for head or coil alone, whatever the state of the other. Empty if it is tracked.
std::string headLossInWords(const NavigationState& state);
std::string coilLossInWords(const NavigationState& state);
/// Message for the second coil alone. Empty if it is tracked, or there is none.
std::string secondCoilLossInWords(const NavigationState& state);

/// Titles of all lost objects, head first: "FACE COVERED", "COIL NOT SEEN". A common cause is named once.
std::vector<std::string> lossTitles(const NavigationState& state);

}  // namespace facenav::session
