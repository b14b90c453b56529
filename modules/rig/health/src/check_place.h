#pragma once
// Where a board or a marker was in one measurement of a rig's check. Camera frame, mm.

#include "facenav/health/rig_lengths.h"
#include "facenav/health/verify_rig.h"

namespace facenav::health {

// A camera's own picture of a board that fits worse than this, and than some times the calibration's rms, is
// of another lens.
constexpr double kOtherLensRms_px = 0.6;

struct CheckPlace {
  Eigen::Vector3d middle_mm, normal;
};

CheckPlace placeOf(const SingleView& view, const cameras::Board& board);
CheckPlace placeOf(const SquareObservation& marker, const cameras::StereoRig& rig);
/// None where a place could not be measured.
CheckMotion motionBetween(const CheckPlace& a, const CheckPlace& b);

}  // namespace facenav::health
