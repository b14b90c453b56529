#pragma once
// What is known of a machine vision camera before a board is seen, as a Gaussian prior. A board that is seen
// at one distance hardly tells the principal point from the tangential distortion and from the camera's turn:
// without a prior the three run away together. Views that determine them override it.

#include <Eigen/Core>

#include "facenav/cameras/stereo_rig.h"

namespace facenav::cameras {

/// The prior linearised at a rig: residuals in standard deviations, and their derivatives.
struct PriorTerms {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;  // a row per residual, a column per parameter of the rig (order: StereoRig)
};

/// `is_tangential` false: p1 and p2 are held at 0.
PriorTerms priorTerms(const CameraModel& left, const CameraModel& right, const cv::Size& image_size,
                      bool is_tangential);

}  // namespace facenav::cameras
