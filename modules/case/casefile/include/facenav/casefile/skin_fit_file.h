#pragma once
// skin_fit.vtp: how well the measured face fits the MRI's skin. Vertices are the measured points in Mri (mm),
// with point data `residual_mm` (signed along the MRI skin's outward normal) and `is_inlier` (1: used in the
// fit).

#include <filesystem>
#include <vector>

#include "facenav/geometry/point.h"
#include "facenav/registration/aligner.h"

namespace facenav::casefile {

/// Writes the whole file, 0600. Points with no skin within 100 mm are left out. Throws Error.
void writeSkinFit(const registration::AlignmentResult& alignment, const PointCloud<Camera>& face,
                  const std::filesystem::path& path);

}  // namespace facenav::casefile
