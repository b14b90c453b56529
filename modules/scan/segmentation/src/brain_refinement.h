#pragma once
// Refines BET's smooth surface to tissue with closed sulci. Tissue has the intensity of grey or white matter,
// and lies near that surface and near the connected body of white matter. (BET leaks into the neck where the
// skull base is thin or blurred, but muscle has no such body.) It must be reachable from that body downhill
// in intensity, which excludes dura. Erosion separates it from eyes and vessels; it is then grown back within
// tissue. At the end sulci and ventricles are closed.

#include "brain_tissue.h"
#include "facenav/segmentation/brain_growth.h"

namespace facenav::segmentation {

/// Computes once what all limits of tissue share. Several threads may call it.
class Refinement {
 public:
  /// `flat`: bias-corrected, cubic voxels; `calm`: the same, smoothed. Keeps references to both. `first` is
  /// on their grid. `open_fluid`: value of fluid in voxels without tissue.
  Refinement(const volume::Volume& flat, const volume::Volume& calm, const volume::Mask& first,
             const TissueModel& tissue, float open_fluid, const BrainGrowth& growth);
  /// Brain mask for the settings' limits; may be empty.
  volume::Mask brain() const { return brain(0, growth_.rise); }
  /// Brain mask for other limits. `stricter`: added to both limits of tissue. `rise`: increase allowed on the
  /// way downhill from white matter.
  volume::Mask brain(double stricter, double rise) const;

 private:
  /// Tissue above `share` within the region.
  volume::Mask tissueAbove(double share) const;

  const volume::Volume &flat_, &calm_;
  TissueModel tissue_;
  float open_fluid_;
  BrainGrowth growth_;
  volume::Mask region_;      // near the first surface and near the connected body of white matter
  volume::Mask white_;       // the connected body of white matter
  volume::Mask near_white_;  // within the distance of the cortex from white matter
};

}  // namespace facenav::segmentation
