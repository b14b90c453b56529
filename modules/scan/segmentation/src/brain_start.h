#pragma once
// First estimate of the brain's place: the head's top and girth give the centre and size of a ball well
// inside the brain. This holds for any length of neck and shoulder in the scan (a plain centre of gravity
// would lie in the throat). Works on a RAS grid with cubic voxels.

#include "bet_surface.h"

namespace facenav::segmentation {

struct BrainStart {
  BetSphere sphere;
  BetIntensities intensities;
};

/// Working volume: `volume` minus its robust minimum, so that air is about 0, on a RAS grid of cubic voxels
/// with some millimetres of air around it. All later steps use this volume. Non-finite values count as air.
volume::Volume workingVolume(const volume::Volume& volume, double spacing_mm);
/// Mean of 2 x 2 x 2 voxels, from voxel (first, first, first) on.
volume::Volume halved(const volume::Volume& volume, int first = 0);

/// Throws Error "no brain can be modelled: ..." where no head-sized object is there.
BrainStart findBrainStart(const volume::Volume& working);
/// Moves `start` to the ball of the brain itself, found by growing a rough surface: top and girth depend on
/// the head's position in the scanner, this ball does not. Throws Error as findBrainStart() does, and
/// Cancelled.
BrainStart centredOnBrain(const volume::Volume& working, const BrainStart& start, double fractional_threshold,
                          TaskMonitor& monitor);

}  // namespace facenav::segmentation
