#pragma once
// From BET's smooth surface to tissue with closed sulci: what has the intensity of grey or white matter near
// that surface and not far from the connected body of white matter (BET leaks into the neck where the skull
// base is thin or blurred, but muscle has no such body), reached from that body downhill in intensity (dura
// is not), torn off from eyes and vessels by erosion, grown back where it is tissue; then sulci and
// ventricles are closed.

#include "brain_tissue.h"
#include "facenav/segmentation/brain_growth.h"

namespace facenav::segmentation {

/// What all limits of tissue share is worked out once; safe to ask from several threads.
class Refinement {
 public:
  /// `flat`: bias-corrected, cubic voxels; `calm`: the same, smoothed; both kept by reference; `first` on
  /// their grid.
  /// `open_fluid`: the value of fluid without any tissue in its voxels.
  Refinement(const volume::Volume& flat, const volume::Volume& calm, const volume::Mask& first,
             const TissueModel& tissue, float open_fluid, const BrainGrowth& growth);
  /// May be empty.
  volume::Mask brain() const { return brain(0, growth_.rise); }
  /// `stricter`: added to both limits of tissue; `rise`: of the way down from white matter.
  volume::Mask brain(double stricter, double rise) const;

 private:
  /// Of the region.
  volume::Mask tissueAbove(double share) const;

  const volume::Volume &flat_, &calm_;
  TissueModel tissue_;
  float open_fluid_;
  BrainGrowth growth_;
  volume::Mask region_;      // near the first surface and near the connected body of white matter
  volume::Mask white_;       // that body
  volume::Mask near_white_;  // as far from white matter as cortex reaches
};

}  // namespace facenav::segmentation
