#pragma once
// Estimates the turn of the right camera about its vertical axis at which the face fits the MRI. One linear
// estimate shows only a third of a turn of 0.1 deg, since points that the turn moves off the skin are not
// used as skin. So the cloud is turned back, fitted and estimated again, until no turn remains or the skin
// fits less likely. The estimate and its error are valid at the last turn that fits.

#include "fit_report.h"

namespace facenav::registration {

/// `first`: the fit of the cloud as measured, with its estimate. `size`: that of the face over the scan's at
/// which it is likeliest; the search starts at the turn that explains it. Takes some fits. Returns nothing if
/// `start` names no camera, and the first estimate if no turn fits better.
std::optional<CameraTurn> settledTurn(const ScalpField& scalp, const PointCloud<Camera>& face,
                                      const AlignmentStart& start, const FinalFit& first, double size = 1.0);

/// The points as measured by a right camera that is known to have turned by `rad`.
PointCloud<Camera> turnedBack(PointCloud<Camera> face, const TurnableCamera& right, double rad);

}  // namespace facenav::registration
