#include <gtest/gtest.h>

#include <opencv2/aruco.hpp>

#include "coil_scene.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "support/tracker_contract.h"

namespace facenav::coil_tracking {
namespace {

using namespace testing;

TEST(CoilTracker, KeepsTheContract) {
  const auto rig = roomRig();
  facenav::testing::TrackerContract<CoilTracker, CoilResult> contract;
  contract.make = [] { return makeMarkerCoilTracker(); };
  contract.start = [&](CoilTracker& tracker) { tracker.start(rig, defaultCoil()); };
  contract.track = [](CoilTracker& tracker, const auto& frame) { return tracker.track(frame); };
  const Print print = arucoPrint(cv::aruco::DICT_4X4_50, 7);
  for (int i = 0; i < 5; ++i) {
    SceneOptions options;
    options.seed = unsigned(i + 1);
    contract.frames.push_back(
        renderMarkers(rig, {{print, 60, markerPose(600 - 2 * i, 20, 70, i, {1.0 * i, 0})}}, options));
    contract.frames.back().captured.s = i / 60.0;
  }
  facenav::testing::expectTrackerContract(contract);
}

}  // namespace
}  // namespace facenav::coil_tracking
