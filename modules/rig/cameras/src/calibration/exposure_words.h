#pragma once
// Messages about views whose two exposures were not simultaneous, and the refusal when too few others are
// left.

#include <string>

#include "board_views.h"
#include "lens_choice.h"

namespace facenav::cameras {

/// Throws Error when too few views are left without those in which the board moved.
void requireSimultaneous(const BoardViews& task, const TrustedViews& trusted);

/// Warnings about a rig made in spite of such views; empty when there are none.
std::vector<std::string> simultaneityWarnings(const BoardViews& task, const TrustedViews& trusted,
                                              const Calibration& result);

/// Reason why view `i` is not used.
std::string reasonFor(const BoardViews& task, const TrustedViews& trusted, const StereoRig& rig,
                      std::size_t i);

}  // namespace facenav::cameras
