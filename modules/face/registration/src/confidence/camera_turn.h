#pragma once
// The turn of the right camera about its vertical axis at which the face fits the MRI. One linear estimate
// shows only a third of a turn of 0.1 deg: what the turn moves away from the skin does not count as skin. So
// the cloud is turned back, fitted again, and estimated again, until nothing is left. There the estimate
// holds, and so does its error.

#include "fit_report.h"

namespace facenav::registration {

/// `first`: the fit of the cloud as measured, with its estimate. Takes some fits. Nothing where `start` names
/// no camera. Where no turn fits better, the first estimate.
std::optional<CameraTurn> settledTurn(const ScalpField& scalp, const PointCloud<Camera>& face,
                                      const AlignmentStart& start, const FinalFit& first);

/// The points as they are measured by a right camera that is known to have turned by `rad`.
PointCloud<Camera> turnedBack(PointCloud<Camera> face, const TurnableCamera& right, double rad);

}  // namespace facenav::registration
