#pragma once
// What is said, and refused, where the two exposures of a view were not simultaneous.

#include <string>

#include "board_views.h"
#include "lens_choice.h"

namespace facenav::cameras {

/// Throws Error where so few views are left without those in which the board moved that no rig should rest on
/// them.
void requireSimultaneous(const BoardViews& task, const TrustedViews& trusted);

/// For a rig that was made all the same; empty where nothing was seen of it.
std::vector<std::string> simultaneityWarnings(const BoardViews& task, const TrustedViews& trusted,
                                              const Calibration& result);

/// Why view `i` is not used.
std::string reasonFor(const BoardViews& task, const TrustedViews& trusted, const StereoRig& rig,
                      std::size_t i);

}  // namespace facenav::cameras
