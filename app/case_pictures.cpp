#include "case_pictures.h"

#include "facenav/casefile/file_group.h"
#include "facenav/scene/cortex_picture.h"
#include "facenav/scene/png.h"
#include "facenav/session/surface_distance_picture.h"

namespace facenav::app {

namespace fs = std::filesystem;

void writePrivatePng(const RgbImage& image, const fs::path& path) {
  casefile::FileGroup group(path.parent_path());
  scene::writePng(image, group.staging() / path.filename());
  group.commit(path.filename().string());
}

RgbImage surfaceDistancePicture(const surface::DetailedCortex& cortex,
                                const surface::ModelDistance& figures) {
  const double full_mm = scene::distanceScale_mm(figures.cortex_to_model);
  const auto colour = [full_mm](double mm) { return scene::distanceColour(mm, full_mm); };
  return session::drawSurfaceDistance(cortex, figures, full_mm, colour);
}

void writeSurfaceDistance(const surface::DetailedCortex& cortex, const surface::ModelDistance& figures,
                          const fs::path& case_folder) {
  writePrivatePng(surfaceDistancePicture(cortex, figures), case_folder / "surface_distance.png");
}

}  // namespace facenav::app
