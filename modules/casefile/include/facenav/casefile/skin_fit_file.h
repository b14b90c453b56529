#pragma once
// skin_fit.vtp: the map of the skin's fit. The measured points in Mri (mm) as vertices, with point data
// `residual_mm` (signed along the MRI skin's outward normal) and `is_inlier` (1: counted in the fit).

#include <filesystem>
#include <vector>

#include "facenav/geometry/point.h"
#include "facenav/registration/aligner.h"

namespace facenav::casefile {

/// A whole file, 0600. Points without a counterpart on the skin are left out. Throws Error.
void writeSkinFit(const registration::AlignmentResult& alignment, const PointCloud<Camera>& face,
                  const std::filesystem::path& path);

}  // namespace facenav::casefile
