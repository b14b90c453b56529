#pragma once
// SkinFieldPose: the head's pose from skin matches if skin has moved over the bone. Rigid motion and a smooth
// field of skin motion are estimated together. Neighbouring windows that move together (a cheek, a lock of
// hair) have the weight of few observations. The prior of the field comes from skin_mobility.h. Windows and
// nodes of the field have Cauchy errors: most skin stays, some moves far. The posterior covariance of the
// pose includes the skin's motion. Known limit: a whole forehead that moves far beyond its mobility moves the
// pose by more than the covariance predicts. In: matches with offsets (px) from a pose near by.

#include <optional>
#include <vector>

#include "skin_points.h"

namespace facenav::head_tracking {

struct SkinFieldPose {
  Vector6d xi = Vector6d::Zero();              // (w rad, v mm) about the points' centre, Head
  Matrix6d covariance = Matrix6d::Identity();  // covariance of xi
  std::vector<double> residual_px;             // per match, with the motion of head and skin
};

/// Iterations of reweighting, of this solution and of the one without a field.
constexpr int kReweightings = 12;

/// Solves for pose and skin motion. Returns nothing if the matches do not determine a pose.
std::optional<SkinFieldPose> solveWithSkinField(const SkinPoints& points,
                                                const std::vector<SkinMatch>& matches);

}  // namespace facenav::head_tracking
