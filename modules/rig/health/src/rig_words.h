#pragma once
// Verdicts that need texts of their own (rig_words.cpp has the texts of all).

#include "facenav/health/camera_drift.h"
#include "facenav/health/rig_state.h"

namespace facenav::health {

RigVerdict markerContradicts();
RigVerdict movedOnMount(double turn_deg);
/// The tracked face is seen at two poses by the two cameras, and nothing tells which of both causes it is.
RigVerdict placesDisagree();

}  // namespace facenav::health
