#pragma once
// Pictures stored in a case. They show the patient's face and brain, so only this user may read them (0600).

#include <filesystem>

#include "facenav/core/rgb_image.h"
#include "facenav/surface/detailed_cortex.h"

namespace facenav::steps {

void writePrivatePng(const RgbImage& image, const std::filesystem::path& path);

/// Draws the distance of the phi-theta surface from the cortex.
RgbImage surfaceDistancePicture(const surface::DetailedCortex& cortex, const surface::ModelDistance& figures);
/// Writes it as surface_distance.png into the case.
void writeSurfaceDistance(const surface::DetailedCortex& cortex, const surface::ModelDistance& figures,
                          const std::filesystem::path& case_folder);

}  // namespace facenav::steps
