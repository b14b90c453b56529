#pragma once
// The face as the MRI shows it, from the front and from both sides, with the landmarks where they were
// measured and the measures drawn between them: what a person compares with the patient.

#include "facenav/core/rgb_image.h"
#include "facenav/surface/face_measures.h"

namespace facenav::pictures {

/// Three views side by side, 2 pixels a mm, in the head's own axes; the front view has the patient's right on
/// the left, as one faces a person.
RgbImage drawFaceMeasures(const surface::ScalpSurface& scalp, const surface::FaceLandmarks& landmarks,
                          const std::vector<surface::FaceMeasure>& measures);

}  // namespace facenav::pictures
