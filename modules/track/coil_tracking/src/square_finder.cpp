#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::coil_tracking {

health::SquareFinder squareFinder(std::shared_ptr<CoilTracker> tracker, const cameras::StereoRig& rig,
                                  const CoilModel& coil) {
  if (!tracker) return {};
  tracker->start(rig, coil);
  return [tracker](const cameras::StereoFrame& frame) { return tracker->track(frame).observation; };
}

}  // namespace facenav::coil_tracking
