#pragma once
// What calibration and matching leave in all depths of a face alike: no residual of an alignment shows it,
// its error bound must hold it.

#include "facenav/cameras/stereo_rig.h"
#include "facenav/geometry/point.h"

namespace facenav::workflow {

/// Standard error of the depth of a face measured with `rig`, Camera, mm: from the covariance of the rig's
/// calibration where its file carries one, else what a good calibration leaves (0.02 px). 0 for no points.
double sharedDepthSigma_mm(const cameras::StereoRig& rig, const PointCloud<Camera>& face);

}  // namespace facenav::workflow
