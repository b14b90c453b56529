#pragma once
// The report of a calibration to the user: parameters with their errors, effect at the head, each view, and
// advice.

#include "board_views.h"

namespace facenav::cameras {

/// Fills parameters, views, at_head and warnings of `result`; its rig and figures must be set.
void report(const BoardViews& task, const TrustedViews& trusted, Calibration& result);

}  // namespace facenav::cameras
