#pragma once
// Place of a board or a marker in one measurement of a rig's check. Camera frame, mm.

#include "facenav/health/rig_lengths.h"
#include "facenav/health/verify_rig.h"

namespace facenav::health {

// Rms of a camera's own picture of a board. If it is larger, and some times larger than the calibration's,
// the picture is of another lens.
constexpr double kOtherLensRms_px = 0.6;

struct CheckPlace {
  Eigen::Vector3d middle_mm, normal;
};

CheckPlace placeOf(const SingleView& view, const cameras::Board& board);
CheckPlace placeOf(const SquareObservation& marker, const cameras::StereoRig& rig);
/// Motion between two places; none if a place could not be measured.
CheckMotion motionBetween(const CheckPlace& a, const CheckPlace& b);

}  // namespace facenav::health
