#pragma once
// Makes a scan from a labelled head, with its exact truth: the head turned, scaled and bent a little, each
// class of tissue painted with a drawn mean and spread, blurred to a scanner's sharpness, shaded, noisy. The
// idea is SynthSeg's (Billot et al. 2023, see head_labels.h). Independent of the program that trains the
// brain prior, so that a score on these heads does not test a generator against itself.

#include <map>

#include "facenav/evaluation/head_labels.h"

namespace facenav::evaluation {

/// Contrast. `t1`: means and spreads drawn from the published statistics; `any`: an own value for each class.
enum class SyntheticContrast { t1, any };

struct SyntheticHead {
  volume::Volume scan;
  volume::Mask tissue;  // on the scan's grid, sulci open; closedAndFilled makes the true mask
};

/// Ranges to draw from, typical of scanners and adults; chosen before any head was segmented.
struct SyntheticRanges {
  double turn_deg = 10;                        // about each axis, either way
  double least_size = 0.93, most_size = 1.07;  // of the head
  double bend_mm = 2.5;                        // largest displacement of the smooth deformation, each axis
  double least_blur_mm2 = 0.15, most_blur_mm2 = 0.45;  // variance of the blur, each axis
  double least_bias = 0.2, most_bias = 0.4;            // largest |log gain| in the head
  double least_noise = 0.01, most_noise = 0.03;        // of the 98th percentile, both channels
};

/// Makes a head on the labels' own grid. Deterministic for a seed. Throws Error if the background has no
/// statistics.
SyntheticHead makeSyntheticHead(const LabelledHead& head, const std::map<int, LabelStatistics>& statistics,
                                SyntheticContrast contrast, unsigned seed,
                                const SyntheticRanges& ranges = {});

}  // namespace facenav::evaluation
