#pragma once
// Contrast of a scan, from the brain within a first mask: in a T1 the white matter, which lies deeper than
// the cortex, is brighter than it, and fluid is the darkest.

#include <string>

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// `weak_t1`: white matter is the brightest, but fluid is not much darker than grey matter.
enum class ContrastKind { t1, weak_t1, t2, flair, proton_density };

struct ContrastSeen {
  double deep_to_rim = 1;   // median value deep in the brain divided by that of its rim, shading removed
  double fluid_to_rim = 1;  // value of the fluid around it, divided by that of the rim
  ContrastKind kind() const;
  bool isLikeT1() const;    // True also for a weak T1.
  bool isInverted() const;  // True if white matter is darker than grey: no T1.
  /// Text for users: "T1", "T2 (fluid is brightest)", "FLAIR (..)", "PD (..)": the most similar weighting.
  std::string inWords() const;
};

/// Measures the contrast. `coarse`: RAS, voxels of about 2 mm, air 0; `brain`, `fluid`: probabilities on its
/// grid.
ContrastSeen contrastSeen(const volume::Volume& coarse, const volume::Volume& brain,
                          const volume::Volume& fluid);

}  // namespace facenav::segmentation
