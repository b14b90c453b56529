#pragma once
// Identity check: is the face at a fitted pose the patient's? The decision is by likelihood ratio of patient
// to other person. The observation is the share of windows in place. The windows are on skin that hardly
// moves over the bone (bridge of the nose, forehead, temples). A window is in place if its best match lies
// where the pose and the smooth motion of the skin (skin_field.h) predict it: a raised brow moves firm skin
// as one, another person's skin matches in places that no smooth motion joins. Windows of 8 mm survive
// compression.

#include <array>
#include <string>

#include "recovery_pose.h"

namespace facenav::head_tracking {

struct Identity {
  std::array<double, 2> side_share = {0, 0};  // share of windows in place in each camera alone
  double in_place_share = 0.0;                // 0..1, share of the windows in view that are in place
  int windows = 0;                            // number of windows in view
  double log_likelihood_ratio = 0.0;          // patient to other person, natural logarithm

  enum class Verdict { patient, other, undecided };
  Verdict verdict() const;
  /// True if windows are in view, so that the skin says something.
  bool isAnswered() const;
  /// True if the face is rather the patient's than not; that does not suffice to show its pose.
  bool isLikelyPatient() const { return isAnswered() && logOdds() > 0; }

 private:
  double logOdds() const;
};

/// Identity at a pose from fitRecoveryPose.
Identity identityOf(const cameras::StereoRig& rig, const SkinPoints& points, const SkinView& then,
                    const RecoveryPose& pose);

}  // namespace facenav::head_tracking
