#pragma once
// Verdicts with words of their own (rig_words.cpp holds the words of all).

#include "facenav/health/camera_drift.h"
#include "facenav/health/rig_state.h"

namespace facenav::health {

RigVerdict markerContradicts();
RigVerdict movedOnMount(double turn_deg);

}  // namespace facenav::health
