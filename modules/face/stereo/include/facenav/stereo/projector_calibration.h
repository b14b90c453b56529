#pragma once
// Calibrates a projector with the calibrated cameras. They measure in space what it lights (a face, a wall, a
// board). Its code shows which of its pixels lights each place, and a lens and a pose are fitted to that. The
// scene must have depth, or be shown at several distances.

#include <string>
#include <vector>

#include "facenav/cameras/projector_model.h"
#include "facenav/core/error.h"
#include "facenav/stereo/projector_code.h"

namespace facenav::stereo {

/// A place that both cameras and the projector see.
struct LitPlace {
  Eigen::Vector2d left_px, right_px, projector_px;
  Point<Camera> point;
  double epipolar_px = 0;  // distance between the two pixels and each other's epipolar line
};

/// Places of equal code in both pictures, at every `step_px` pixels of the left one. Places farther than 1 px
/// from the epipolar line are left out.
std::vector<LitPlace> matchCodes(const cameras::StereoRig& rig, const DecodedCode& left,
                                 const DecodedCode& right, int step_px = 1);

struct ProjectorCalibration {
  cameras::ProjectorModel projector;
  double rms_px = 0, held_out_px = 0;  // projector px: rms of the fit; median of the places left out of it
  int places = 0, left_out = 0;        // number of places used, and of outliers
  double nearest_mm = 0, farthest_mm = 0;
};

/// Thrown if no lens and pose fit the places: something moved while the pictures were taken.
class ProjectorMisfit : public Error {
 public:
  ProjectorMisfit()
      : Error("something moved while the pictures were taken", "", "hold still, and take the scene again") {}
};

/// Throws Error if there are too few places or they lie in one plane; ProjectorMisfit.
ProjectorCalibration calibrateProjector(const std::vector<LitPlace>& places, const ProjectorCode& code);

}  // namespace facenav::stereo
