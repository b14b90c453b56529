#include "facenav/treat/live_outputs.h"

#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "facenav/casefile/case_store.h"
#include "facenav/core/error.h"
#include "facenav/interop/invesalius_space.h"
#include "facenav/links/igtl_content.h"
#include "facenav/treat/served_tracker.h"
#include "support/ball_case.h"
#include "support/free_port.h"
#include "support/igtl_client.h"
#include "support/small_relay.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using testing::LoopbackClient;

class LiveCase : public ::testing::Test {
 protected:
  LiveCase()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballWithBrain(), {}, false)) {}
  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
};

TEST_F(LiveCase, TheMriIsSentWithItsPlaceInRas) {
  const auto mri = store_.mri();
  const auto content = caseContent(store_.folder(), "IMAGE", "");
  ASSERT_TRUE(content);
  const auto image = links::readImage(*content);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->size, mri.grid.size);
  EXPECT_EQ(image->voxels, mri.voxels);
  // The protocol's origin is the middle of the grid, as 3D Slicer reads it.
  const Eigen::Vector3d half(0.5 * (mri.grid.size[0] - 1), 0.5 * (mri.grid.size[1] - 1),
                             0.5 * (mri.grid.size[2] - 1));
  const Eigen::Vector3d first_mm = image->centre_mm - image->steps_mm * half;
  EXPECT_LT((first_mm - mri.grid.toMri(Eigen::Vector3d::Zero()).mm).norm(), 1e-3);
}

TEST_F(LiveCase, SurfacesAndTargetsAreSentAndNothingElse) {
  const auto scalp = links::readSurface(*caseContent(store_.folder(), "POLYDATA", "Scalp"));
  ASSERT_TRUE(scalp);
  EXPECT_EQ(scalp->triangles.size(), store_.scalp().mesh.triangles.size());
  EXPECT_TRUE(caseContent(store_.folder(), "POLYDATA", "Cortex"));
  guidance::TreatmentPlan plan;
  guidance::Target target;
  target.name = "M1";
  target.cortex_point = Point<Mri>(10, 20, 30);
  plan.targets.push_back(target);
  store_.setTargets(plan);
  const auto points = links::readPoints(*caseContent(store_.folder(), "POINT", "Targets"));
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 1u);
  EXPECT_EQ(points->front().name, "M1");
  EXPECT_EQ(points->front().position_mm, Eigen::Vector3d(10, 20, 30));
  EXPECT_FALSE(caseContent(store_.folder(), "POLYDATA", "../case.json"));
  EXPECT_FALSE(caseContent(store_.folder(), "IMAGE", "label"));
}

TEST_F(LiveCase, TheRelayGetsTheCoilInTheSpaceOfTheCasesMri) {
  testing::SmallRelay relay;
  LiveOutputs outputs;
  outputs.setCase(store_.folder());
  outputs.open(relay.words());
  const Eigen::Vector3d place(-10, 20, 60);
  session::NavigationState state;
  state.is_aligned = true;
  state.camera_T_mri = Tracked<RigidTransform<Camera, Mri>>(
      RigidTransform<Camera, Mri>(Eigen::Quaterniond::Identity(), {0, 0, 0}), 1.0);
  state.camera_T_coil = Tracked<RigidTransform<Camera, Coil>>(
      RigidTransform<Camera, Coil>(Eigen::Quaterniond::Identity(), place), 1.0);
  const std::string topic = "From Neuronavigation: Send coil pose";
  for (int i = 0; i < 600 && relay.data(topic).empty(); ++i) {
    outputs.publish(state);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_FALSE(relay.data(topic).empty());
  const interop::InvesaliusSpace space(store_.mri().grid);
  const auto truth = space.markerOf(Eigen::Isometry3d(Eigen::Translation3d(place)));
  const auto found = relay.data(topic)[0]["coord"].get<interop::InvesaliusNumbers>();
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(found[i], truth[i], 1e-3) << i;
}

TEST(LiveOutputs, AreOpenedOnceAndClosedByTheirWords) {
  LiveOutputs outputs;
  const std::string words = "igtl:127.0.0.1:" + std::to_string(testing::freePort());
  outputs.open(words);
  EXPECT_THROW(outputs.open(words), Error);
  outputs.open("json:9");
  EXPECT_EQ(outputs.names(), (std::vector<std::string>{words, "json:9"}));
  outputs.close(words);
  EXPECT_EQ(outputs.names(), std::vector<std::string>{"json:9"});
  outputs.close();
  EXPECT_TRUE(outputs.isEmpty());
}

TEST(ServedCoil, ThePoseOfAnotherTrackerIsTheCoilsPose) {
  const int port = testing::freePort();
  const auto server = links::openLiveOutput("igtl:127.0.0.1:" + std::to_string(port));
  Eigen::Isometry3d camera_T_tracker(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()));
  camera_T_tracker.translation() = Eigen::Vector3d(100, 0, 50);
  Eigen::Isometry3d tracker_T_coil(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()));
  tracker_T_coil.translation() = Eigen::Vector3d(1, 2, 500);
  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();
  coil.markers.front().coil_T_marker =
      RigidTransform<Coil, Marker>(Eigen::Quaterniond::Identity(), {0, 40, -90});
  const auto tracker =
      makeServedCoilTracker("igtl://127.0.0.1:" + std::to_string(port) + "/Coil", camera_T_tracker);
  tracker->start({}, coil);
  const cameras::StereoFrame frame;
  EXPECT_FALSE(tracker->track(frame).isTracked());
  std::optional<coil_tracking::CoilPose> pose;
  for (int i = 0; i < 1000 && !pose; ++i) {
    auto sent = std::make_shared<links::LiveFrame>();
    sent->utc = std::chrono::system_clock::now();
    sent->poses = {{"Coil", tracker_T_coil}};
    server->publish(sent);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const auto result = tracker->track(frame);
    if (result) pose = *result;
  }
  ASSERT_TRUE(pose);
  const auto camera_T_coil = (pose->camera_T_marker * coil.marker_T_coil()).isometry();
  EXPECT_LT((camera_T_coil.matrix() - (camera_T_tracker * tracker_T_coil).matrix()).norm(), 1e-3);
  std::this_thread::sleep_for(std::chrono::milliseconds(280));
  EXPECT_FALSE(tracker->track(frame).isTracked());  // an old pose is not used
}

TEST(ServedCoil, TheTrackersPlaceIsReadFromAFile) {
  const testing::TemporaryFolder folder;
  const auto file = folder.path() / "tracker.json";
  std::ofstream(file) << R"({"camera_T_tracker": [1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1]})";
  EXPECT_EQ(readTrackerPose(file).translation(), Eigen::Vector3d(5, 6, 7));
  std::ofstream(file) << R"({"camera_T_tracker": [-1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1]})";  // mirrored
  EXPECT_THROW(readTrackerPose(file), Error);
}

}  // namespace
}  // namespace facenav::steps
