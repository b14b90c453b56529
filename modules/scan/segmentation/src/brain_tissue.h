#pragma once
// Tissue classes of this scan: fluid, grey and white matter as three Gaussians, fitted by expectation
// maximisation within a first brain mask. Alternates with the fit of a smooth multiplicative bias field
// (after Wells 1996, van Leemput 1999: a polynomial of the third order, fitted to the logarithm of value over
// class mean).

#include <Eigen/Core>

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

struct TissueClass {
  double mean = 0, deviation = 0, share = 0;
};

struct TissueModel {
  TissueClass fluid, grey, white;
  Eigen::Matrix<double, 20, 1> bias = Eigen::Matrix<double, 20, 1>::Zero();  // of log gain, third order
  Eigen::Vector3d centre_mm = Eigen::Vector3d::Zero();

  /// (white - grey) / white: 0.2 to 0.4 in T1 MR.
  double contrast() const;
};

volume::Mask ballOf(const volume::VoxelGrid& grid, const Eigen::Vector3d& centre_mm, double radius_mm);

/// Fits only the bias, before any mask is known: a polynomial of the second order, fitted to the logarithm of
/// the values within a ball well inside the brain. Fluid and bright vessels are rejected by their residuals.
TissueModel fitRoughBias(const volume::Volume& image, const Eigen::Vector3d& centre_mm, double radius_mm,
                         float air);

/// Fits bias and classes. `core`: safely inside the brain (a first mask, eroded). Air must be 0. `start`:
/// initial classes, if roughly known; without them, a core without fluid would have part of its grey matter
/// classified as fluid.
TissueModel fitTissue(const volume::Volume& image, const volume::Mask& core,
                      const TissueModel* start = nullptr);
/// Removes the bias from the image (axis-aligned, cubic voxels).
volume::Volume corrected(volume::Volume image, const TissueModel& model);

}  // namespace facenav::segmentation
