#pragma once
// The landmarks of a case's scalp: found on the skin, else through the atlas, or set by hand; stored in the
// case.

#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/surface/scalp_landmarks.h"

namespace facenav::steps {

/// Finds each landmark in two ways and takes the one with the smaller error: on the skin itself, or the
/// template's landmark mapped by the atlas and moved to the nearest skin. `atlas` may be null.
surface::ScalpLandmarks findLandmarks(const surface::ScalpSurface& scalp, const atlas::AtlasMap* atlas);

/// Returns the case's landmarks. The first call finds and stores them, which takes a second or two.
surface::ScalpLandmarks landmarksOf(const casefile::CaseStore& store, const surface::ScalpSurface& scalp);
/// Sets a landmark by hand at the skin nearest to `p`, and stores it. Throws Error if `p` is more than 20 mm
/// from the skin.
surface::ScalpLandmarks setLandmark(const casefile::CaseStore& store, const surface::ScalpSurface& scalp,
                                    surface::Landmark which, const Point<Mri>& p, const std::string& by);
/// Finds the landmark again and replaces the one set by hand.
surface::ScalpLandmarks findLandmarkAgain(const casefile::CaseStore& store,
                                          const surface::ScalpSurface& scalp, surface::Landmark which);

}  // namespace facenav::steps
