#pragma once
// The landmarks of a case's scalp: found on the skin, else through the atlas, or set by hand; kept in the
// case.

#include <string>

#include "facenav/casefile/case_store.h"
#include "facenav/surface/scalp_landmarks.h"

namespace facenav::steps {

/// Of two ways the one with the smaller error: as the skin shows it, or the template's landmark carried to
/// this head by the atlas and put on the nearest skin. `atlas` may be null.
surface::ScalpLandmarks findLandmarks(const surface::ScalpSurface& scalp, const atlas::AtlasMap* atlas);

/// Those of the case; found and kept at the first call. Takes a second or two then.
surface::ScalpLandmarks landmarksOf(const casefile::CaseStore& store, const surface::ScalpSurface& scalp);
/// Puts a landmark at the place of the skin nearest to `p`, by hand, and keeps it. Throws Error for a place
/// more than 20 mm from the skin.
surface::ScalpLandmarks setLandmark(const casefile::CaseStore& store, const surface::ScalpSurface& scalp,
                                    surface::Landmark which, const Point<Mri>& p, const std::string& by);
/// Finds it again in place of what a hand set.
surface::ScalpLandmarks findLandmarkAgain(const casefile::CaseStore& store,
                                          const surface::ScalpSurface& scalp, surface::Landmark which);

}  // namespace facenav::steps
