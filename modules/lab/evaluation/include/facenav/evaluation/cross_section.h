#pragma once
// The alignment's cross-sections (paper, figure 11): an MRI slice with the nearby points of the face cloud in
// red.

#include <opencv2/core.hpp>
#include <vector>

#include "facenav/volume/slice_plane.h"
#include "facenav/volume/volume.h"

namespace facenav::evaluation {

struct CrossSectionOptions {
  double thickness_mm = 1.0;  // largest distance of a drawn point from the plane, either side
  int scale = 3;              // image pixels per mm
};

/// Draws an 8-bit BGR picture of `plane` with the points of `cloud_mri` near it; `caption` at the top, R and
/// L at the sides of axial and coronal planes.
cv::Mat drawCrossSection(const volume::Volume& mri, volume::Anatomical orientation, const Point<Mri>& through,
                         const PointCloud<Mri>& cloud_mri, const CrossSectionOptions& options);

}  // namespace facenav::evaluation
