#include "facenav/prepare/case_pictures.h"

#include "facenav/pictures/surface_distance_picture.h"
#include "facenav/scene/cortex_picture.h"
#include "facenav/scene/png.h"

namespace facenav::steps {

namespace fs = std::filesystem;

void writePrivatePng(const RgbImage& image, const fs::path& path) {
  scene::writePng(image, path, FileAccess::owner_only);
}

RgbImage surfaceDistancePicture(const surface::DetailedCortex& cortex,
                                const surface::ModelDistance& figures) {
  const double full_mm = scene::distanceScale_mm(figures.cortex_to_model);
  const auto colour = [full_mm](double mm) { return scene::distanceColour(mm, full_mm); };
  return pictures::drawSurfaceDistance(cortex, figures, full_mm, colour);
}

void writeSurfaceDistance(const surface::DetailedCortex& cortex, const surface::ModelDistance& figures,
                          const fs::path& case_folder) {
  writePrivatePng(surfaceDistancePicture(cortex, figures), case_folder / "surface_distance.png");
}

}  // namespace facenav::steps
