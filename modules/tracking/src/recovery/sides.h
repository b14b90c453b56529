#pragma once
// Whether both pictures of a pair are of one moment, asked of the skin itself: a point found in both cameras
// lies on its epipolar line, whatever the face does, unless the head or the skin moved between the two
// exposures. A rigid motion of the head shifts the whole face off its lines, a grimace a part of it.

#include <vector>

#include "skin_points.h"

namespace facenav::tracking {

struct EpipolarOffset {
  int points = 0;         // found in both cameras
  double median_px = 0;   // of the signed distances from the epipolar lines, right camera
  double spread_px = 0;   // robust standard deviation about that
  double region_px = 0;   // root mean square of the regions' medians, their noise taken off
};

/// Of the last search of a pose (RecoveryPose::matches).
EpipolarOffset epipolarOffset(const stereo::StereoRig& rig, const SkinPoints& points,
                              const std::vector<SkinMatch>& matches);

}  // namespace facenav::tracking
