#include "facenav/prepare/brain_surfaces.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/segmentation/tissue_share.h"

namespace facenav::steps {
namespace {

// Spacing of the cortex' grid; a sulcus is 1-2 mm wide.
constexpr double kFinest_mm = 0.8, kCoarsest_mm = 1.0;
constexpr int kSmoothing = 10;  // removes the voxels' steps, keeps the width of a gyrus

}  // namespace

BrainSurfaces buildBrainSurfaces(const volume::Volume& mri, const volume::Mask& brain, TaskMonitor& monitor) {
  BrainSurfaces surfaces;
  surfaces.model = surface::buildBrainModel(mri, brain, {}, monitor);
  try {
    const double spacing_mm = std::clamp(mri.grid.spacing_mm().minCoeff(), kFinest_mm, kCoarsest_mm);
    const auto tissue = segmentation::tissueShare(mri, brain, spacing_mm, monitor);
    surfaces.cortex.mesh = surface::extractCortex(tissue, kSmoothing, monitor);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    surfaces.has_open_sulci = false;
    surfaces.cortex.mesh = surface::extractCortex(brain, {}, monitor);
  }
  monitor.report("measuring the phi-theta surface", 0.5);
  surfaces.cortex.distance_mm = surface::signedDistances_mm(surfaces.cortex.mesh, surfaces.model.mesh);
  surfaces.distance = surface::distanceBetween(surfaces.cortex, surfaces.model);
  return surfaces;
}

}  // namespace facenav::steps
