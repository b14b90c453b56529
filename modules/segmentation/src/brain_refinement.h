#pragma once
// From BET's smooth surface to tissue with closed sulci: what has the intensity of grey or white matter near
// that surface and not far from the connected body of white matter (BET leaks into the neck where the skull
// base is thin or blurred, but muscle has no such body), reached from that body downhill in intensity (dura
// is not), torn off from eyes and vessels by erosion, grown back where it is tissue; then sulci and
// ventricles are closed.

#include "brain_tissue.h"

namespace facenav::segmentation {

struct RefinementOptions {
  double search_mm = 8;        // tissue is sought this far outside the first surface
  double core_share = 0.48;    // lower limit of the core, between open fluid (0) and grey matter's mean (1)
  double tissue_share = 0.35;  // the same of what is grown from white matter: most of a voxel may be fluid
  double rise = 0.05;          // of open fluid to white matter: what noise may rise on the way down
  double brightest = 1.35;     // upper limit, times white matter: above are fat and vessels
  double white_tear_mm = 1.0;  // white matter thinner than twice this does not belong to its connected body
  double white_reach_mm = 14;  // tissue lies at most this far from that body
  double cortex_mm = 7;    // the torn core lies this near to white matter: sinuses and dura lie further out
  double tear_mm = 2.0;    // bridges thinner than twice this are torn
  double regrow_mm = 4.5;  // from the torn core back, through tissue
  double sulcus_mm = 3.6;  // sulci up to twice this wide are closed
  double hull_mm = 10;     // radius of a coarse closing, within which ..
  double deep_mm = 5;      // .. what lies this deep is inside: ventricles, fissures
  double smooth_mm = 1.5;  // spikes thinner than twice this are cut
};

/// What all limits of tissue share is worked out once; safe to ask from several threads.
class Refinement {
 public:
  /// `flat`: bias-corrected, cubic voxels; `calm`: the same, smoothed; both kept by reference; `first` on
  /// their grid.
  /// `open_fluid`: the value of fluid without any tissue in its voxels.
  Refinement(const volume::Volume& flat, const volume::Volume& calm, const volume::Mask& first,
             const TissueModel& tissue, float open_fluid);
  /// May be empty. `stricter`: added to both limits of tissue; `rise`: of the way down from white matter.
  volume::Mask brain(double stricter = 0, double rise = RefinementOptions().rise) const;

 private:
  /// Of the region.
  volume::Mask tissueAbove(double share) const;

  const volume::Volume &flat_, &calm_;
  TissueModel tissue_;
  float open_fluid_;
  volume::Mask region_;      // near the first surface and near the connected body of white matter
  volume::Mask white_;       // that body
  volume::Mask near_white_;  // as far from white matter as cortex reaches
};

}  // namespace facenav::segmentation
