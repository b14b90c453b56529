#pragma once
// Tests whether the values of a series are those of a magnitude image. The air around the head is dark there:
// it lies at the low end of the values. In a phase image and an MP2RAGE UNI it is noise over their whole
// range; in a real or imaginary part it lies in the middle.

#include "facenav/dicom/series.h"

namespace facenav::dicom {

/// Reads the middle image. False if its air lies in the middle of its values; true also where that cannot be
/// told (unreadable, no air).
bool hasDarkAir(const SeriesInfo& series);

/// The test on one image, rows x columns `values`.
bool hasDarkAir(const std::vector<float>& values, int rows, int columns);

}  // namespace facenav::dicom
