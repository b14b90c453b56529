#pragma once
// TREAT: the field of the coil as it is held now, computed on a thread of its own at low priority, so that
// tracking does not feel it. The thread waits for the session's newest state by itself; poses that come while
// it computes are left out. A field carries frame and time of its pose: who shows it must not show it for
// another moment (mayBeShown). Fields in V/m at a rate of the current of 1 A/us.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/core/latest_value.h"
#include "facenav/plan/pose_fields.h"
#include "facenav/plan/threshold_dose.h"
#include "facenav/session/navigation_state.h"

namespace facenav::steps {

/// What fields are wanted of.
struct LiveFieldSubject {
  casefile::CaseStore store;
  std::string coil;                                         ///< as efield::fieldCoil takes it
  std::shared_ptr<const surface::TriangleMesh> drawn = {};  ///< surface to colour; null: none
  std::optional<HotspotThreshold> threshold = {};
};

/// Where the coil is held at one frame.
struct LivePose {
  std::int64_t frame = -1;
  Timestamp arrived;
  CoilPose mri_T_coil;
  std::optional<guidance::Target> target = {};
  PoseBound bound = {};
};
/// The pose of a state; nothing if head or coil is lost or withheld. Its bound is that of the alignment at
/// the target, with the tracker's own error of the coil added.
std::optional<LivePose> livePose(const session::NavigationState& state);

/// What the plan gives at the target, at its planned pose.
struct PlannedStrength {
  guidance::Target target;
  double at_target = 0;
  std::optional<ThresholdDose> dose = {};  ///< nothing: no motor threshold with its hotspot is known
};

struct LiveField {
  std::int64_t frame = -1;
  Timestamp arrived;
  FieldTier tier = FieldTier::local_sphere;
  double usual_error = 0;
  std::optional<guidance::Target> target = {};
  std::optional<double> at_target;  ///< nothing without a target
  FieldRange range;                 ///< of at_target (PoseFields::rangeAt)
  std::optional<double> planned;    ///< at the target from the planned pose
  double peak = 0;
  Point<Mri> peak_place;
  double largest_didt_A_per_us = 0;  ///< of the coil at 100 % output; 0: not known
  std::vector<float> strength = {};  ///< at the vertices of the drawn surface: that of the nearest cortex
};

/// True if the field may be shown with this state: it is of this target, its pose is at most as old as a pose
/// may be (or a little newer), and head and coil are tracked now.
bool mayBeShown(const LiveField& field, const session::NavigationState& now);

/// Share of the motor threshold's field in %: the live field at `output_pct` over the hotspot's at its
/// threshold. The coil's rate cancels out.
double ofThreshold_pct(const LiveField& field, double output_pct, const ThresholdDose& dose);

class LiveFieldWorker {
 public:
  /// `done`: called on the worker's thread after each result; may be empty, must return at once.
  explicit LiveFieldWorker(std::function<void()> done = {});
  ~LiveFieldWorker();
  LiveFieldWorker(const LiveFieldWorker&) = delete;
  LiveFieldWorker& operator=(const LiveFieldWorker&) = delete;

  /// Sets case, coil and surface; nothing: none. Results of the last subject are dropped at once.
  void use(std::optional<LiveFieldSubject> subject);
  /// Wants the planned strength of this target; returns at once.
  void plan(const guidance::Target& target);
  /// Computes the field of each newest state from now on; null: of none. When the states change, the last
  /// field is dropped at once, and nothing of the earlier states appears afterwards.
  void follow(std::shared_ptr<const LatestValue<session::NavigationState>> states);

  /// The newest field; null: none, or head or coil was lost or withheld since.
  std::shared_ptr<const LiveField> latest() const;
  /// The newest planned strength; null: none.
  std::shared_ptr<const PlannedStrength> planned() const;
  /// Why there is no field; empty: no fault.
  std::string failure() const;
  /// Number of fields computed since the start.
  int computed() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::steps
