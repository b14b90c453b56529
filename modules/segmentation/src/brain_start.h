#pragma once
// Where the brain is, before anything is known about it: the head's top and girth give the centre and size of
// a ball that lies well inside the brain, whatever length of neck and shoulder the scan holds (a plain centre
// of gravity sinks into the throat). Works on a RAS grid with cubic voxels.

#include "bet_surface.h"

namespace facenav::segmentation {

struct BrainStart {
  BetSphere sphere;
  BetIntensities intensities;
};

/// `volume` less its robust minimum (so that air is about 0, whatever the offset), on a RAS grid of cubic
/// voxels with some millimetres of air around it, through which all the working steps run. Values that are
/// not finite count as air.
volume::Volume workingVolume(const volume::Volume& volume, double spacing_mm);
/// Mean of 2 x 2 x 2 voxels, from voxel (first, first, first) on.
volume::Volume halved(const volume::Volume& volume, int first = 0);

/// Throws Error "no brain can be modelled: ..." where no head-sized object is there.
BrainStart findBrainStart(const volume::Volume& working);
/// `start` on the ball of the brain itself, as a rough surface grown from it shows: top and girth depend on
/// how the head lies in the scanner, this does not. Throws Error likewise, and Cancelled.
BrainStart centredOnBrain(const volume::Volume& working, const BrainStart& start, double fractional_threshold,
                          TaskMonitor& monitor);

}  // namespace facenav::segmentation
