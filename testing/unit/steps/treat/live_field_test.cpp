#include "facenav/treat/live_field.h"

#include <gmock/gmock.h>

#include <thread>

#include "facenav/efield/built_in_coils.h"
#include "facenav/plan/plan_edits.h"
#include "support/ball_with_cortex.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

template <class Condition>
bool waitUntil(Condition condition) {
  for (int i = 0; i < 4000 && !condition(); ++i) std::this_thread::sleep_for(5ms);
  return condition();
}

class LiveFieldTest : public ::testing::Test {
 protected:
  LiveFieldTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballWithCortex(), {}, false)),
        top_(targetOverCortex(plannedHead(store_), "top", Point<Mri>(0, 0, 68))) {}

  LiveFieldSubject subject() const {
    return {store_, "figure8-70", std::make_shared<const surface::TriangleMesh>(store_.brain()->mesh)};
  }
  /// The coil `up_mm` above its planned pose.
  LivePose poseAt(std::int64_t frame, double up_mm) const {
    const RigidTransform<frames::Coil, frames::Coil> step(Eigen::Quaterniond::Identity(), {0, 0, -up_mm});
    return {frame, Timestamp{double(frame)}, coilPoseOf(top_) * step, top_, {2, 1}};
  }
  /// A state with the coil at a pose.
  session::NavigationState stateAt(const LivePose& pose) const {
    session::NavigationState state;
    state.frame = pose.frame;
    state.arrived = pose.arrived;
    const RigidTransform<Camera, Mri> camera_T_mri(Eigen::Quaterniond::Identity(), {0, 0, 600});
    state.camera_T_mri = {camera_T_mri, 0.9};
    state.camera_T_coil = {camera_T_mri * pose.mri_T_coil, 0.9};
    coil_tracking::CoilPose coil;
    coil.covariance.diagonal() << 1e-6, 1e-6, 1e-6, 0.01, 0.01, 0.04;
    state.coil = {coil, 0.9};
    state.chosen = std::make_shared<const session::ChosenTarget>(session::ChosenTarget{top_, 0.7, 1.5});
    return state;
  }

  void publish(const session::NavigationState& state) {
    states_->publish(std::make_shared<const session::NavigationState>(state));
  }

  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  guidance::Target top_;
  std::shared_ptr<LatestValue<session::NavigationState>> states_ =
      std::make_shared<LatestValue<session::NavigationState>>();
};

TEST_F(LiveFieldTest, TheFieldIsThatOfTheHeldCoilWithItsGapAndOfThePlanBeside) {
  LiveFieldWorker worker;
  worker.use(subject());
  publish(stateAt(poseAt(7, 5)));
  worker.follow(states_);
  ASSERT_TRUE(waitUntil([&] { return worker.latest() != nullptr; })) << worker.failure();
  const auto field = worker.latest();
  EXPECT_EQ(field->frame, 7);
  const ReadHead head(store_);
  const auto coil = efield::figureEight70();
  const auto strength = [&](const CoilPose& pose) {
    return head.near(pose)->at(coil, pose, Eigen::Matrix3Xd(top_.cortex_point.mm)).norm();
  };
  EXPECT_NEAR(*field->at_target, strength(poseAt(7, 5).mri_T_coil), 1e-6);
  EXPECT_NEAR(*field->planned, strength(coilPoseOf(top_)), 1e-6);
  EXPECT_NEAR(*field->at_target / *field->planned, 0.81, 0.04) << "5 mm of lift";
  EXPECT_LT(field->range.low, 0.72 * *field->at_target);
  EXPECT_GT(field->range.high, 1.28 * *field->at_target);
  ASSERT_EQ(field->strength.size(), store_.brain()->mesh.vertices_mm.size());
  EXPECT_LE(*std::max_element(field->strength.begin(), field->strength.end()), field->peak * 1.0001);
}

TEST_F(LiveFieldTest, TheNewestPoseIsComputedWithoutBeingAskedFor) {
  LiveFieldWorker worker;
  worker.use(subject());
  worker.follow(states_);
  for (int frame = 1; frame <= 200; ++frame) publish(stateAt(poseAt(frame, 0.05 * frame)));
  ASSERT_TRUE(waitUntil([&] { return worker.latest() && worker.latest()->frame == 200; }));
  EXPECT_LT(worker.computed(), 100) << "poses that waited were left out";
  const int computed = worker.computed();
  std::this_thread::sleep_for(60ms);
  EXPECT_EQ(worker.computed(), computed) << "a pose is computed once";
  for (int frame = 201; frame <= 205; ++frame) {
    publish(stateAt(poseAt(frame, 0)));
    ASSERT_TRUE(waitUntil([&] { return worker.latest()->frame == frame; }));
  }
  EXPECT_EQ(worker.computed(), computed + 5);
  worker.use(subject());
  EXPECT_EQ(worker.latest(), nullptr);
  EXPECT_TRUE(waitUntil([&] { return worker.latest() != nullptr; })) << "the state that is there counts";
  worker.use(std::nullopt);
  EXPECT_EQ(worker.latest(), nullptr);
}

TEST_F(LiveFieldTest, NoFieldStaysOfAPoseThatIsLostWithheldOrNoLongerFollowed) {
  LiveFieldWorker worker;
  worker.use(subject());
  worker.follow(states_);
  const auto has_field = [&] { return worker.latest() != nullptr; };
  int frame = 0;
  const auto show = [&] {
    publish(stateAt(poseAt(++frame, 1)));
    return waitUntil([&] { return has_field() && worker.latest()->frame == frame; });
  };
  auto withheld = stateAt(poseAt(1, 0));
  withheld.withheld.emplace();
  for (const auto& without : {session::blanked(withheld, LostReason::no_face), withheld}) {
    ASSERT_TRUE(show());
    publish(without);
    EXPECT_TRUE(waitUntil([&] { return !has_field(); }));
  }
  ASSERT_TRUE(show());
  for (int i = 0; i < 20; ++i) {  // also while one is computed
    publish(stateAt(poseAt(++frame, 1)));
    worker.follow(nullptr);
    std::this_thread::sleep_for(2ms);
    EXPECT_FALSE(has_field()) << i;
    worker.follow(states_);
  }
  ASSERT_TRUE(show());
  const auto others = std::make_shared<LatestValue<session::NavigationState>>();
  worker.follow(others);
  std::this_thread::sleep_for(30ms);
  EXPECT_FALSE(has_field()) << "another session has no state yet";
}

TEST_F(LiveFieldTest, ALostWithheldOldOrOtherTargetsFieldIsNotShown) {
  const auto now = stateAt(poseAt(10, 0));
  LiveField field;
  field.frame = 9;
  field.arrived = {9.9};
  field.target = top_;
  EXPECT_TRUE(mayBeShown(field, now));
  auto later = now;
  later.arrived = {10.4};
  EXPECT_FALSE(mayBeShown(field, later)) << "half a second old";
  field.arrived = {10.1};
  EXPECT_TRUE(mayBeShown(field, now)) << "newer than the state that the page took";
  field.arrived = {9.9};
  EXPECT_FALSE(mayBeShown(field, session::blanked(now, LostReason::no_face)));
  auto withheld = now;
  withheld.withheld.emplace();
  EXPECT_FALSE(mayBeShown(field, withheld));
  auto other = now;
  auto moved = top_;
  moved.name = "another";
  other.chosen = std::make_shared<const session::ChosenTarget>(session::ChosenTarget{moved});
  EXPECT_FALSE(mayBeShown(field, other));
  EXPECT_FALSE(livePose(session::blanked(now, LostReason::no_face)));
  EXPECT_FALSE(livePose(withheld));
  const auto pose = livePose(now);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->bound.mm, std::hypot(1.5, 1.96 * 0.2), 1e-9)
      << "the alignment's bound and the coil's own";
  EXPECT_NEAR(pose->bound.deg, 1.96 * 1e-3 * 180 / M_PI, 1e-9);
  EXPECT_LT((pose->mri_T_coil.translation_mm() - coilPoseOf(top_).translation_mm()).norm(), 1e-9);
}

TEST_F(LiveFieldTest, TheShareOfTheThresholdNeedsNoRateOfTheCoil) {
  HotspotThreshold threshold{top_, 48};
  auto wanted = subject();
  wanted.threshold = threshold;
  LiveFieldWorker worker;
  worker.use(wanted);
  worker.plan(top_);
  ASSERT_TRUE(waitUntil([&] { return worker.planned() != nullptr; }));
  const auto dose = worker.planned()->dose;
  ASSERT_TRUE(dose);
  EXPECT_NEAR(dose->output_pct, 48, 1e-6) << "the target is the hotspot";
  publish(stateAt(poseAt(1, 0)));
  worker.follow(states_);
  ASSERT_TRUE(waitUntil([&] { return worker.latest() != nullptr; }));
  EXPECT_NEAR(ofThreshold_pct(*worker.latest(), 48, *dose), 100, 0.01);
  EXPECT_NEAR(ofThreshold_pct(*worker.latest(), 57.6, *dose), 120, 0.01);
}

TEST_F(LiveFieldTest, ACaseWithoutABrainHasAReasonAndNoField) {
  const auto plain = casefile::CaseStore::create(folder_.path() / "plain", testing::ballCase(), {}, false);
  LiveFieldWorker worker;
  worker.use(LiveFieldSubject{plain, "figure8-70"});
  publish(stateAt(poseAt(1, 0)));
  worker.follow(states_);
  ASSERT_TRUE(waitUntil([&] { return !worker.failure().empty(); }));
  EXPECT_THAT(worker.failure(), HasSubstr("no brain model"));
  EXPECT_EQ(worker.latest(), nullptr);
  worker.use(subject());
  EXPECT_TRUE(waitUntil([&] { return worker.latest() != nullptr; })) << "another case is not affected";
}

}  // namespace
}  // namespace facenav::steps
