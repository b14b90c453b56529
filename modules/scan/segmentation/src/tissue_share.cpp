#include "facenav/segmentation/tissue_share.h"

#include <algorithm>
#include <cmath>

#include "brain_checks.h"
#include "brain_refinement.h"
#include "brain_start.h"
#include "contrast_seen.h"
#include "facenav/anatomy/brain_norms.h"
#include "facenav/core/error.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr double kMargin_mm = 4;  // margin, so that the field reaches 0 within the grid
constexpr double kRim_mm = 1.5;   // rim around the mask: fluid, not yet skull
constexpr double kCore_mm = 4;    // deeper within the mask there is only brain

Volume shareOf(const Volume& flat, const TissueModel& tissue) {
  Volume share = flat;
  const float fluid = float(tissue.fluid.mean), per = 1.f / float(tissue.grey.mean - tissue.fluid.mean);
  for (float& value : share.voxels) value = std::clamp((value - fluid) * per, 0.f, 1.f);
  return share;
}

/// Throws Error if white matter is darker than grey: the classes would be confused.
void requireWhiteAboveGrey(const Volume& image, const Mask& brain) {
  const Volume coarse = halved(image);
  const Volume inside = halved({brain.grid, {brain.voxels.begin(), brain.voxels.end()}, {}, {}});
  const Volume no_fluid{coarse.grid, std::vector<float>(coarse.voxels.size()), {}, {}};
  if (contrastSeen(coarse, inside, no_fluid).isInverted())
    throw Error("the sulci cannot be opened: white matter is darker than grey matter", {},
                "a T1-weighted MR is needed");
}

/// Fills ventricles and cisterns: voxels too deep for a sulcus, and fluid that no path joins to the outside.
void fillEnclosed(Volume& share, const Mask& brain) {
  const auto depth_mm = volume::depthWithin(brain);
  Mask tissue{share.grid, std::vector<std::uint8_t>(share.voxels.size())};
  for (std::size_t v = 0; v < tissue.voxels.size(); ++v)
    tissue.voxels[v] = share.voxels[v] >= 0.5f || depth_mm[v] > anatomy::kDeepestSulcus_mm;
  const Mask filled = fillHoles(tissue);
  for (std::size_t v = 0; v < tissue.voxels.size(); ++v)
    if (filled.voxels[v] && share.voxels[v] < 0.5f) share.voxels[v] = 1;
}

}  // namespace

Volume tissueShare(const Volume& mri, const Mask& brain, double spacing_mm, TaskMonitor& monitor) {
  monitor.report("opening the sulci", 0);
  const volume::VoxelGrid grid = volume::gridAround(brain, spacing_mm, kMargin_mm);
  const float air = volume::percentile(mri, 0.02);
  Volume image = volume::resample(mri, grid);
  for (float& value : image.voxels) value = std::isfinite(value) ? std::max(0.f, value - air) : 0.f;
  const Mask inside = volume::resample(brain, grid);
  requireWhiteAboveGrey(image, inside);
  monitor.report("opening the sulci", 0.3);
  // In a core without fluid, part of the grey matter would be classified as fluid. Therefore the first fit
  // includes the fluid around the brain.
  const Volume calm = smoothed(image);
  const TissueModel rough = fitTissue(calm, dilate(inside, kRim_mm));
  const TissueModel tissue = fitTissue(calm, erode(inside, kCore_mm), &rough);
  requireTissueContrast(tissue);
  monitor.report("opening the sulci", 0.6);
  Volume share = shareOf(corrected(image, tissue), tissue);
  // Adds a slope at the mask's own edge where it cuts through tissue (dura, brainstem).
  Volume slope{grid, std::vector<float>(inside.voxels.begin(), inside.voxels.end()), {}, {}};
  slope = smoothed(slope);
  for (std::size_t v = 0; v < share.voxels.size(); ++v)
    share.voxels[v] = std::min(share.voxels[v], slope.voxels[v]);
  fillEnclosed(share, inside);
  return share;
}

}  // namespace facenav::segmentation
