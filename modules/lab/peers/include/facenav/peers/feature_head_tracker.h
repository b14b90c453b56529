#pragma once
// FeatureHeadTracker: a peer method to compare head tracking with, "features7": the 2010 paper's seven
// features, NCC, equations 2-5.

#include <memory>

#include "facenav/head_tracking/head_tracker.h"

namespace facenav::peers {

/// Makes "features7". Creates its own face detector, or uses the given one (the landmark model takes 100 MB).
std::unique_ptr<head_tracking::HeadTracker> makeFeatureHeadTracker(
    std::shared_ptr<const face::FaceDetector> detector = nullptr);  // default: its own

}  // namespace facenav::peers
