#pragma once
// Tests whether two images at one place are copies of one image.

#include "slice_stack.h"

namespace facenav::dicom {

/// True if both decode to the same values. Damaged pixels count as different.
bool isSameImage(const std::vector<SliceHeader>& headers, ImageRef a, ImageRef b);

}  // namespace facenav::dicom
