#pragma once
// Identity: is the face at a fitted pose the patient's? A decision by likelihood: how probable what was seen
// is for the patient, by how probable it is for another person. Looks: the share of windows on skin that
// hardly moves over the bone (bridge of the nose, forehead, temples) whose best place lies where the rigid
// pose puts it. Windows of 8 mm survive compression; another person's skin has its detail elsewhere. Shape:
// how far the measured upper face lies from the reference's (face_shape.h).

#include <array>
#include <optional>
#include <string>

#include "face_shape.h"
#include "recovery_pose.h"

namespace facenav::head_tracking {

struct Identity {
  std::array<double, 2> side_share = {0, 0};  // the same in each camera alone
  double looks_share = 0.0;                   // 0..1, of the windows in view
  int windows = 0;                            // in view
  std::optional<double> shape_rms_mm;         // robust, where the shape was measured
  double log_likelihood_ratio = 0.0;          // patient : other, natural logarithm

  enum class Verdict { patient, other, undecided };
  Verdict verdict() const;
  /// Whether enough is in view for an answer at all.
  bool isAnswered() const;
};

/// Of a pose that fitRecoveryPose found. `shape`: where it was measured.
Identity identityOf(const cameras::StereoRig& rig, const SkinPoints& points, const SkinView& then,
                    const RecoveryPose& pose, const std::optional<ShapeFit>& shape);

}  // namespace facenav::head_tracking
