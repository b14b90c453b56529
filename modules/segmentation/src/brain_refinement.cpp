#include "brain_refinement.h"

#include <algorithm>
#include <array>

#include "facenav/volume/mask_morphology.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

/// What looks like white matter within the first surface.
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
                       float open_fluid)
    : flat_(flat), tissue_(tissue), open_fluid_(open_fluid) {
  const RefinementOptions reach;
  const Mask white = whiteMatter(calm, first, tissue);
  // The connected body of white matter: what the neck's muscles, which look like grey matter, do not have.
  region_ = intersection(dilate(first, reach.search_mm),
                         dilate(largestPart(erode(white, reach.white_tear_mm)), reach.white_reach_mm));
  near_white_ = dilate(largestPart(white), reach.cortex_mm);
}

Mask Refinement::brain(double tissue_share, bool is_near_white) const {
  const RefinementOptions options;
  const float low = open_fluid_ + float(tissue_share) * (float(tissue_.grey.mean) - open_fluid_);
  const float high = float(tissue_.white.mean * options.brightest);
  Mask near = region_;
  for (std::size_t v = 0; v < near.voxels.size(); ++v)
    near.voxels[v] &= flat_.voxels[v] > low && flat_.voxels[v] < high;
  const Mask torn = erode(near, options.tear_mm);
  const Mask core = largestPart(is_near_white ? intersection(torn, near_white_) : torn);
  Mask brain = intersection(dilate(core, options.regrow_mm), near);
  const Mask deep = erode(dilate(brain, options.hull_mm), options.hull_mm + options.deep_mm);
  brain = unionOf(close(brain, options.sulcus_mm), deep);
  return largestPart(open(fillHoles(close(brain, options.smooth_mm)), options.smooth_mm));
}

}  // namespace facenav::segmentation
