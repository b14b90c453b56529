#pragma once
// What a person is told of a finished calibration: its parameters with their errors, its effect at the head,
// each view, and what would make it better.

#include "board_views.h"

namespace facenav::cameras {

/// Fills parameters, views, at_head and warnings of `result`, whose rig and figures are there.
void report(const BoardViews& task, const TrustedViews& trusted, Calibration& result);

}  // namespace facenav::cameras
