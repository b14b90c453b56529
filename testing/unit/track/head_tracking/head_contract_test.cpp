#include <gtest/gtest.h>

#include "head_scene.h"
#include "support/tracker_contract.h"

namespace facenav {
namespace {

using namespace head_tracking::testing;
using head_tracking::HeadResult;
using head_tracking::HeadTracker;

TEST_F(HeadTrackers, EachKeepsTheContract) {
  for (const bool is_model : {true, false}) {
    SCOPED_TRACE(is_model ? "model" : "features7");
    facenav::testing::TrackerContract<HeadTracker, HeadResult> contract;
    contract.make = [&] { return make(is_model); };
    contract.start = [&](HeadTracker& tracker) { start(tracker, true); };
    contract.track = [](HeadTracker& tracker, const auto& frame) { return tracker.track(frame); };
    for (int i = 0; i < 5; ++i) contract.frames.push_back(face_->render(rig_, stillView(i)));
    facenav::testing::expectTrackerContract(contract);
  }
}

/// After the drift watchdog's alarm, learnt key frames are dropped and the patient is found from the
/// reference.
TEST_F(HeadTrackers, EachFindsThePatientInTheFrameThatPutsItsLearningInDoubt) {
  for (const bool is_model : {true, false}) {
    const auto tracker = make(is_model);
    start(*tracker, true);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(tracker->track(face_->render(rig_, turnedView(i, 2.0 * i))));
    const SyntheticView view = turnedView(3, 6.0);
    const auto pose = tracker->track(face_->render(rig_, view), {{}, true});
    ASSERT_TRUE(pose) << (is_model ? "model" : "features7");
    EXPECT_LT(errorOf(*pose, view).at_point_mm, 3.0);
    EXPECT_EQ(pose.loss_detail, head_tracking::LossDetail::unknown);
  }
}

}  // namespace
}  // namespace facenav
