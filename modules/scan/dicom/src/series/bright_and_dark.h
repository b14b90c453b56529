#pragma once
// MR images stored with bright and dark exchanged: MONOCHROME1 displays the smallest value white (PS3.3
// C.7.6.3.1.2). Skin and brain are found where air is dark.

#include "facenav/volume/volume.h"
#include "header/slice_header.h"

namespace facenav::dicom {

/// True for MR whose header says MONOCHROME1. CT keeps its Hounsfield units.
bool isStoredInverted(const SliceHeader& header);
/// Exchanges bright and dark (v becomes max - v) where the corners, which show air, are bright. Some programs
/// write MONOCHROME1 and do not invert: dark corners stay as they are.
void darkenAir(volume::Volume& volume);

}  // namespace facenav::dicom
