#include "brain_refinement.h"

#include <algorithm>
#include <array>

#include "downhill_growth.h"
#include "facenav/volume/mask_morphology.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

/// Voxels within the first surface with the intensity of white matter.
Mask whiteMatter(const Volume& calm, const Mask& first, const TissueModel& tissue) {
  const float low = float(0.5 * (tissue.grey.mean + tissue.white.mean));
  const float high =
      float(tissue.white.mean + std::max(3 * tissue.white.deviation, 0.15 * tissue.white.mean));
  Mask white = first;
  for (std::size_t v = 0; v < white.voxels.size(); ++v)
    white.voxels[v] &= calm.voxels[v] > low && calm.voxels[v] < high;
  return white;
}

}  // namespace

Refinement::Refinement(const Volume& flat, const Volume& calm, const Mask& first, const TissueModel& tissue,
                       float open_fluid, const BrainGrowth& growth)
    : flat_(flat), calm_(calm), tissue_(tissue), open_fluid_(open_fluid), growth_(growth) {
  const Mask white = whiteMatter(calm, first, tissue);
  // The connected body of white matter. The neck's muscles look like grey matter but are not near it.
  region_ = intersection(dilate(first, growth.search_mm),
                         dilate(largestPart(erode(white, growth.white_tear_mm)), growth.white_reach_mm));
  white_ = largestPart(white);
  near_white_ = dilate(white_, growth.cortex_mm);
}

Mask Refinement::tissueAbove(double share) const {
  const float low = open_fluid_ + float(share) * (float(tissue_.grey.mean) - open_fluid_);
  const float high = float(tissue_.white.mean * growth_.brightest);
  Mask tissue = region_;
  for (std::size_t v = 0; v < tissue.voxels.size(); ++v)
    tissue.voxels[v] &= flat_.voxels[v] > low && flat_.voxels[v] < high;
  return tissue;
}

Mask Refinement::brain(double stricter, double rise) const {
  const Mask bright = tissueAbove(growth_.core_share + stricter);
  // The growth uses the smoothed image, since noise makes single voxels brighter everywhere. Values above
  // white matter count as white matter: where the skull's marrow touches a crown, it is brighter than that
  // crown's grey matter.
  const Mask tissue = growDownhill(calm_, white_, tissueAbove(growth_.tissue_share + stricter),
                                   {open_fluid_, float(tissue_.white.mean), rise});
  const Mask torn = intersection(erode(intersection(tissue, bright), growth_.tear_mm), near_white_);
  Mask brain = intersection(dilate(largestPart(torn), growth_.regrow_mm), tissue);
  const Mask deep = erode(dilate(brain, growth_.hull_mm), growth_.hull_mm + growth_.deep_mm);
  brain = unionOf(close(brain, growth_.sulcus_mm), deep);
  return largestPart(open(fillHoles(close(brain, growth_.smooth_mm)), growth_.smooth_mm));
}

}  // namespace facenav::segmentation
