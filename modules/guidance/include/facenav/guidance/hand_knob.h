#pragma once
// A first guess of the hand area of M1 ("hand knob"; MNI -37, -21, 58, mirrored on the right) from the
// brain's extent alone: width and length are scaled to those of Colin27's brain (x -72..71, y -106..73 mm),
// depth is taken down from the vertex (z = 84) at the mean of both scales, since masks end low at different
// heights of the brainstem. Uncertainty: the head's pitch and roll in the scanner go in undiminished (10
// degrees of pitch move it by about 12 mm along the strip), so about 10 mm (1 sigma) in a usual scan. Enough
// for a demonstration and as the start of a search for the hotspot; it is no localisation. Where the case has an
// atlas registration, that maps handKnob() instead.

#include "facenav/surface/brain_model.h"
#include "facenav/volume/volume.h"

namespace facenav::guidance {

enum class Side { left, right };  // the patient's

/// In MNI space.
Point<Mni> handKnob(Side side);
/// On the brain model's surface: the vertex nearest to the scaled point. Throws Error for an empty model.
Point<Mri> handKnobGuess(const surface::BrainModel& brain, Side side);
/// The scaled point itself, from the mask's bounding box. Throws Error for an empty mask.
Point<Mri> handKnobGuess(const volume::Mask& brain, Side side);

}  // namespace facenav::guidance
