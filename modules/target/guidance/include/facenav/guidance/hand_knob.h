#pragma once
// A first guess of the hand area of M1 ("hand knob"; MNI -37, -21, 58, mirrored on the right) from the
// brain's extent alone. Width and length are scaled to those of Colin27's brain (x -72..71, y -106..73 mm).
// Depth is measured down from the vertex (z = 84) with the mean of both scales, since masks end at different
// heights of the brainstem. Uncertainty: about 10 mm (1 sigma) in a usual scan. The head's pitch and roll in
// the scanner are not corrected; 10 degrees of pitch move the guess by about 12 mm along the strip. The guess
// is the start of the search for the hotspot; it does not localise the hand area. If the case has an atlas
// registration, use handKnob() through it instead.

#include "facenav/surface/brain_model.h"
#include "facenav/volume/volume.h"

namespace facenav::guidance {

enum class Side { left, right };  // the patient's

/// Position of the hand area in MNI space.
Point<Mni> handKnob(Side side);
/// Returns the vertex of the brain model nearest to the scaled point. Throws Error for an empty model.
Point<Mri> handKnobGuess(const surface::BrainModel& brain, Side side);
/// Returns the scaled point itself, computed from the mask's bounding box. Throws Error for an empty mask.
Point<Mri> handKnobGuess(const volume::Mask& brain, Side side);

}  // namespace facenav::guidance
