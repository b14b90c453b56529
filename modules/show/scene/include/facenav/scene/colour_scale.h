#pragma once
// The colours of a number on a scale: from dark blue over red to pale yellow, lighter throughout, so that it
// can be read without seeing colours.

#include "facenav/scene/palette.h"

namespace facenav::scene {

/// `share`: 0 (least) to 1 (most); values beyond are drawn as the ends.
palette::Rgb sequentialColour(double share);

/// The ends of a colour scale; equal ends show every value in the middle colour.
struct ColourRange {
  double low = 0, high = 1;
  double shareOf(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

}  // namespace facenav::scene
