#pragma once
// Where a board or a marker was in one measurement of a rig's check. Camera frame, mm.

#include "facenav/workflow/verify_rig.h"
#include "rig_lengths.h"

namespace facenav::workflow {

// A camera's own picture of a board that fits worse than this, and than some times the calibration's rms, is
// of another lens.
constexpr double kOtherLensRms_px = 0.6;

struct CheckPlace {
  Eigen::Vector3d middle_mm, normal;
};

CheckPlace placeOf(const SingleView& view, const cameras::Board& board);
CheckPlace placeOf(const coil_tracking::MarkerObservation& marker, const cameras::StereoRig& rig);
/// None where a place could not be measured.
CheckMotion motionBetween(const CheckPlace& a, const CheckPlace& b);

}  // namespace facenav::workflow
