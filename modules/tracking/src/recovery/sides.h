#pragma once
// Whether both pictures of a pair are of one moment, asked of the skin itself: a point found in both cameras
// lies on its epipolar line, whatever the face does, unless the head or the skin moved between the two
// exposures. A rigid motion of the head shifts the whole face off its lines, a grimace a part of it.

#include <vector>

#include "skin_points.h"

namespace facenav::tracking {

struct EpipolarOffset {
  int points = 0;        // found in both cameras
  double median_px = 0;  // of the signed distances from the epipolar lines, right camera
  double spread_px = 0;  // robust standard deviation about that

  /// Whether the face lies off its lines by more than matches err. `allowed_px`: what the head's motion
  /// between the two exposures of untriggered cameras explains.
  bool isOutOfStep(double allowed_px = 0.0) const;
  /// The same of a face that is hardly like the patient's: only what another person's skin, matched by
  /// chance, cannot show.
  bool isClearlyOutOfStep() const;
};

/// Of the last search of a pose (RecoveryPose::matches).
EpipolarOffset epipolarOffset(const stereo::StereoRig& rig, const std::vector<SkinMatch>& matches);

}  // namespace facenav::tracking
