#pragma once
// Draws the MRI's face from the front and from both sides, with landmarks and measures. A person compares it
// with the patient.

#include "facenav/core/rgb_image.h"
#include "facenav/surface/face_measures.h"

namespace facenav::pictures {

/// Draws three views side by side, 2 pixels per mm, in the head's own axes. The front view has the patient's
/// right on the left, as when facing a person.
RgbImage drawFaceMeasures(const surface::ScalpSurface& scalp, const surface::FaceLandmarks& landmarks,
                          const std::vector<surface::FaceMeasure>& measures);

}  // namespace facenav::pictures
