#include "brain_refinement.h"

#include "brain_morphology.h"

namespace facenav::segmentation {

using volume::Mask;

volume::Mask refineBrain(const volume::Volume& flat, const Mask& first, const TissueModel& tissue,
                         const RefinementOptions& options) {
  const float low = float(tissue.fluid.mean + options.tissue_share * (tissue.grey.mean - tissue.fluid.mean));
  const float high = float(tissue.white.mean * options.brightest);
  Mask near = dilate(first, options.search_mm);
  for (std::size_t v = 0; v < near.voxels.size(); ++v)
    near.voxels[v] &= flat.voxels[v] > low && flat.voxels[v] < high;
  const Mask core = largestPart(erode(near, options.tear_mm));
  Mask brain = intersection(dilate(core, options.regrow_mm), near);
  const Mask deep = erode(dilate(brain, options.hull_mm), options.hull_mm + options.deep_mm);
  brain = unionOf(close(brain, options.sulcus_mm), deep);
  return largestPart(open(fillHoles(close(brain, options.smooth_mm)), options.smooth_mm));
}

}  // namespace facenav::segmentation
