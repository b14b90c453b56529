#pragma once
// The trackers of a run with a clock around them: processor time of each call, OpenCV's threads off.

#include <memory>

#include "facenav/registration/aligner.h"
#include "facenav/tracking/coil_tracker.h"
#include "facenav/tracking/head_tracker.h"

namespace facenav::app {

/// Where the time of the last call is written; outlives the tracker.
struct LastCall {
  double ms = 0.0;
};

std::unique_ptr<tracking::HeadTracker> timed(std::unique_ptr<tracking::HeadTracker> tracker, LastCall& last);
std::unique_ptr<tracking::CoilTracker> timed(std::unique_ptr<tracking::CoilTracker> tracker, LastCall& last);
std::unique_ptr<registration::Aligner> timed(std::unique_ptr<registration::Aligner> aligner, LastCall& last);

}  // namespace facenav::app
