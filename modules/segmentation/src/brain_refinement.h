#pragma once
// From BET's smooth surface to tissue with closed sulci: what has the intensity of grey or white matter near
// that surface and not far from the connected body of white matter (BET leaks into the neck where the skull
// base is thin or blurred, but muscle has no such body), torn off from dura, eyes and vessels by erosion,
// grown back where it is tissue; then sulci and ventricles are closed.

#include "brain_tissue.h"

namespace facenav::segmentation {

struct RefinementOptions {
  double search_mm = 8;        // tissue is sought this far outside the first surface
  double tissue_share = 0.48;  // lower limit of tissue, between open fluid (0) and grey matter's mean (1)
  double brightest = 1.35;     // upper limit, times white matter: above are fat and vessels
  double white_tear_mm = 1.0;  // white matter thinner than twice this does not belong to its connected body
  double white_reach_mm = 14;  // tissue lies at most this far from that body
  double cortex_mm = 6;    // the torn core lies this near to white matter: sinuses and dura lie further out
  double tear_mm = 2.0;    // bridges thinner than twice this are torn
  double regrow_mm = 4.5;  // from the torn core back, through tissue
  double sulcus_mm = 4;    // sulci up to twice this wide are closed
  double hull_mm = 10;     // radius of a coarse closing, within which ..
  double deep_mm = 5;      // .. what lies this deep is inside: ventricles, fissures
  double smooth_mm = 1.5;  // spikes thinner than twice this are cut
};

/// What all limits of tissue share is worked out once; safe to ask from several threads.
class Refinement {
 public:
  /// `flat`: bias-corrected, cubic voxels, kept by reference; `calm`: the same, smoothed; `first` on their
  /// grid.
  /// `open_fluid`: the value of fluid without any tissue in its voxels.
  Refinement(const volume::Volume& flat, const volume::Volume& calm, const volume::Mask& first,
             const TissueModel& tissue, float open_fluid);
  /// May be empty. `is_near_white`: the core keeps to where cortex reaches from white matter.
  volume::Mask brain(double tissue_share = RefinementOptions().tissue_share, bool is_near_white = true) const;

 private:
  const volume::Volume& flat_;
  TissueModel tissue_;
  float open_fluid_;
  volume::Mask region_;      // near the first surface and near the connected body of white matter
  volume::Mask near_white_;  // as far from white matter as cortex reaches
};

}  // namespace facenav::segmentation
