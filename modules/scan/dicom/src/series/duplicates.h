#pragma once
// Whether two images at one place are two copies of one image.

#include "slice_stack.h"

namespace facenav::dicom {

/// True when both decode to the same values. Damaged pixels count as different.
bool isSameImage(const std::vector<SliceHeader>& headers, ImageRef a, ImageRef b);

}  // namespace facenav::dicom
