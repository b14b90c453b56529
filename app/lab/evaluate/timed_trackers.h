#pragma once
// Wraps the trackers of a run to measure the processor time of each call, without OpenCV's threads.

#include <memory>

#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/head_tracking/head_tracker.h"
#include "facenav/registration/aligner.h"

namespace facenav::app {

/// Time of the last call. Must outlive the tracker.
struct LastCall {
  double ms = 0.0;
};

std::unique_ptr<head_tracking::HeadTracker> timed(std::unique_ptr<head_tracking::HeadTracker> tracker,
                                                  LastCall& last);
std::unique_ptr<coil_tracking::CoilTracker> timed(std::unique_ptr<coil_tracking::CoilTracker> tracker,
                                                  LastCall& last);
std::unique_ptr<registration::Aligner> timed(std::unique_ptr<registration::Aligner> aligner, LastCall& last);

}  // namespace facenav::app
