#pragma once
// Gaussian prior of a machine vision camera before calibration. A board at one distance hardly separates
// principal point, tangential distortion and camera rotation: without a prior the three grow together. Views
// that determine them override it.

#include <Eigen/Core>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// The prior linearised at a rig: residuals in standard deviations, and their derivatives.
struct PriorTerms {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  // a row per residual, a column per parameter of the rig (order: StereoRig)
};

/// Prior at these cameras. `is_tangential` false: p1 and p2 are held at 0.
PriorTerms priorTerms(const CameraModel& left, const CameraModel& right, const cv::Size& image_size,
                      bool is_tangential);

}  // namespace facenav::cameras
