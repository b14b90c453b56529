#pragma once
// A CT's brain: grey and white matter look alike, so the brain prior alone gives its outline, within the
// skull. Hounsfield units.

#include <string>

#include "facenav/volume/volume.h"

namespace facenav::segmentation {

/// True for a CT, by the modality; if that is unknown (NIfTI), by the values.
bool isCt(const volume::Volume& scan);

/// Maps soft tissue to the range from 0 (air, fat's lower end) to the values of bone, as the brain prior
/// needs it.
volume::Volume softTissueWindow(const volume::Volume& ct);

/// Throws Error "no brain can be modelled: .." if the mask is not within a skull (a phantom, a leg), or not
/// as dense as a brain.
void requireSkullAround(const volume::Volume& ct, const volume::Mask& brain);

/// Removes bone and air from the outline.
volume::Mask withinSkull(const volume::Volume& ct, const volume::Mask& brain);

}  // namespace facenav::segmentation
