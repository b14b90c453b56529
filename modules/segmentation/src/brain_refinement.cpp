#include "brain_refinement.h"

#include <algorithm>
#include <array>

#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/smoothing.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

/// The connected body of white matter: what the neck's muscles, which look like grey matter, do not have.
Mask whiteCore(const Volume& flat, const Mask& first, const TissueModel& tissue, double tear_mm) {
  const float low = float(0.5 * (tissue.grey.mean + tissue.white.mean));
  const float high =
      float(tissue.white.mean + std::max(3 * tissue.white.deviation, 0.15 * tissue.white.mean));
  const Volume smooth = smoothed(flat);
  Mask white = first;
  for (std::size_t v = 0; v < white.voxels.size(); ++v)
    white.voxels[v] &= smooth.voxels[v] > low && smooth.voxels[v] < high;
  return largestPart(erode(white, tear_mm));
}

}  // namespace

volume::Mask refineBrain(const volume::Volume& flat, const Mask& first, const TissueModel& tissue,
                         const RefinementOptions& options) {
  const float low = float(tissue.fluid.mean + options.tissue_share * (tissue.grey.mean - tissue.fluid.mean));
  const float high = float(tissue.white.mean * options.brightest);
  Mask near = dilate(first, options.search_mm);
  for (std::size_t v = 0; v < near.voxels.size(); ++v)
    near.voxels[v] &= flat.voxels[v] > low && flat.voxels[v] < high;
  near = intersection(near,
                      dilate(whiteCore(flat, first, tissue, options.white_tear_mm), options.white_reach_mm));
  const Mask core = largestPart(erode(near, options.tear_mm));
  Mask brain = intersection(dilate(core, options.regrow_mm), near);
  const Mask deep = erode(dilate(brain, options.hull_mm), options.hull_mm + options.deep_mm);
  brain = unionOf(close(brain, options.sulcus_mm), deep);
  return largestPart(open(fillHoles(close(brain, options.smooth_mm)), options.smooth_mm));
}

}  // namespace facenav::segmentation
