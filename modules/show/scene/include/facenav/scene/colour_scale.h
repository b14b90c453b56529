#pragma once
// The colours of a number on a scale: from dark blue over red to pale yellow, with rising lightness, so that
// it can be read without colour vision.

#include "facenav/scene/palette.h"

namespace facenav::scene {

/// Colour of `share`, 0 (least) to 1 (most); clamped.
palette::Rgb sequentialColour(double share);

/// Ends of a colour scale; if they are equal, every value has the middle colour.
struct ColourRange {
  double low = 0, high = 1;
  double shareOf(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

}  // namespace facenav::scene
