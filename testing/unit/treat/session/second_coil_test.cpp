// Two coils in one session: each with its own pose, target, table and pulses.

#include <gmock/gmock.h>

#include <fstream>

#include "facenav/casefile/poses_csv.h"
#include "facenav/casefile/session_pulses.h"
#include "facenav/core/error.h"
#include "facenav/session/live_frame.h"
#include "facenav/session/treatment_log.h"
#include "session_fakes.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::session {
namespace {

using ::facenav::testing::PoseNear;
using ::testing::HasSubstr;

const RigidTransform<Camera, Marker> kFirst(Eigen::Quaterniond::Identity(), {20, -60, 550}),
    kSecond(Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY())), {-90, 10, 580});

coil_tracking::CoilModel coilNamed(const std::string& name, int id) {
  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();
  coil.name = name;
  coil.markers.front().id = id;
  return coil;
}

/// The second coil is lost in the frames from `lost_from` on.
class LosableCoil : public fakes::Coil {
 public:
  LosableCoil(const RigidTransform<Camera, Marker>& pose, std::int64_t lost_from)
      : fakes::Coil(pose), lost_from_(lost_from) {}
  coil_tracking::CoilResult track(const cameras::StereoFrame& frame,
                                  const coil_tracking::CoilContext& context) override {
    if (frame.number >= lost_from_) return Lost{LostReason::no_marker};
    return fakes::Coil::track(frame, context);
  }

 private:
  std::int64_t lost_from_;
};

std::unique_ptr<Navigator> twoCoils(std::int64_t head_lost_from = 1000,
                                    std::int64_t second_lost_from = 1000) {
  auto setup = fakes::setup();
  setup.coil = coilNamed("A", 7);
  auto navigator = std::make_unique<Navigator>(
      setup, std::make_unique<fakes::Head>([=](std::int64_t n) {
        return n < head_lost_from ? std::optional(RigidTransform<Camera, Head>()) : std::nullopt;
      }),
      std::make_unique<fakes::Coil>(kFirst));
  navigator->addSecondCoil(coilNamed("B", 8), std::make_unique<LosableCoil>(kSecond, second_lost_from));
  navigator->setTarget(fakes::targetAt(kFirst.reframe<Camera, Coil>()));
  auto other = fakes::targetAt(kSecond.reframe<Camera, Coil>());
  other.target.name = "other spot";
  navigator->setSecondTarget(other);
  return navigator;
}

TEST(SecondCoil, EachHasItsPoseAndItsOwnTarget) {
  const auto state = twoCoils()->process(fakes::frame(1, 0.1));
  ASSERT_TRUE(state.second);
  EXPECT_EQ(state.coil_name, "A");
  EXPECT_EQ(state.second->name, "B");
  EXPECT_THAT(*state.camera_T_coil, PoseNear(kFirst.reframe<Camera, Coil>(), 1e-9, 1e-9));
  EXPECT_THAT(*state.second->camera_T_coil, PoseNear(kSecond.reframe<Camera, Coil>(), 1e-9, 1e-9));
  EXPECT_EQ(state.guidance.state, guidance::State::on_target);
  EXPECT_EQ(state.second->guidance.state, guidance::State::on_target);
  auto navigator = twoCoils();
  auto apart = fakes::targetAt(kSecond.reframe<Camera, Coil>());
  apart.target.mri_T_target = apart.target.mri_T_target * RigidTransform<frames::Target, frames::Target>(
                                                              Eigen::Quaterniond::Identity(), {7, 0, 0});
  navigator->setSecondTarget(apart);
  const auto off = navigator->process(fakes::frame(1, 0.1));
  EXPECT_EQ(off.guidance.state, guidance::State::on_target);
  ASSERT_TRUE(off.second->guidance.values);
  EXPECT_NEAR(off.second->guidance.values->distance_mm, 7, 1e-6);
}

TEST(SecondCoil, ALossIsThatOfItsOwnCoilAndALostHeadLosesBothTargets) {
  const auto navigator = twoCoils(20, 10);
  const auto lost_coil = navigator->process(fakes::frame(10, 0.1));
  EXPECT_TRUE(lost_coil.camera_T_coil);
  EXPECT_FALSE(lost_coil.second->camera_T_coil);
  EXPECT_EQ(lost_coil.guidance.state, guidance::State::on_target);
  EXPECT_EQ(lost_coil.second->guidance.state, guidance::State::lost);
  EXPECT_EQ(secondCoilLossInWords(lost_coil), "COIL NOT SEEN: turn the marker towards the cameras");
  const auto lost_head = twoCoils(20)->process(fakes::frame(20, 0.2));
  EXPECT_TRUE(lost_head.second->camera_T_coil);
  EXPECT_EQ(lost_head.second->guidance.state, guidance::State::lost);
  const auto blank = blanked(lost_head, LostReason::stale);
  EXPECT_FALSE(blank.second->camera_T_coil);
  EXPECT_FALSE(blank.second->coil);
}

TEST(SecondCoil, CoilsThatCannotBeToldApartAreRefused) {
  const auto navigator = twoCoils();
  EXPECT_THROW(navigator->addSecondCoil(coilNamed("B", 7), std::make_unique<fakes::Coil>(kSecond)), Error);
  EXPECT_THROW(navigator->addSecondCoil(coilNamed("A", 8), std::make_unique<fakes::Coil>(kSecond)), Error);
  EXPECT_THROW(navigator->setCoil(coilNamed("C", 8)), Error) << "the second coil's marker";
}

TEST(SecondCoil, IsServedUnderItsOwnNames) {
  const auto frame = liveFrameOf(twoCoils()->process(fakes::frame(1, 0.1)));
  std::map<std::string, links::LivePose> poses;
  for (const auto& each : frame.poses) poses[each.name] = each;
  ASSERT_EQ(poses.size(), 8u);
  EXPECT_LT((poses["Coil2ToTracker"].pose->matrix() - kSecond.matrix()).norm(), 1e-9);
  EXPECT_LT((poses["Coil2ToTarget"].pose->matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-9);
  EXPECT_LT((poses["Coil1ToTracker"].pose->matrix() - kFirst.matrix()).norm(), 1e-9);
  EXPECT_EQ(poses["Coil2ToMri"].coil, "B");
  EXPECT_EQ(poses["CoilToMri"].coil, "A");
}

TEST(SecondCoil, APulseBelongsToTheCoilThatItNamesAndIsNeverGuessed) {
  auto before = posedFrame(twoCoils()->process(fakes::frame(1, 0.1)));
  auto after = before;
  before.taken = {100.0}, after.taken = {100.02};
  for (auto* frame : {&before, &after}) {
    PosedFrame second = *frame->second;
    second.taken = frame->taken;
    frame->second = std::make_shared<const PosedFrame>(second);
  }
  PulseTrigger trigger;
  trigger.at = {100.01};
  trigger.coil = "B";
  const auto of_second = pulseBetween(trigger, before, after);
  EXPECT_EQ(of_second.coil, "B");
  EXPECT_EQ(of_second.status, casefile::PulseStatus::on_target) << of_second.reason;
  EXPECT_EQ(of_second.target->name, "other spot");
  EXPECT_THAT(*of_second.camera_T_coil, PoseNear(kSecond.reframe<Camera, Coil>(), 1e-6, 1e-6));
  trigger.coil = "A";
  EXPECT_EQ(pulseBetween(trigger, before, after).target->name, "spot");
  trigger.coil.clear();
  const auto unknown = pulseBetween(trigger, before, after);
  EXPECT_EQ(unknown.status, casefile::PulseStatus::lost);
  EXPECT_EQ(unknown.reason, "it is not known which of the two coils gave it");
  EXPECT_FALSE(unknown.camera_T_coil);
  EXPECT_TRUE(unknown.t_s);
  trigger.coil = "C";
  EXPECT_EQ(pulseBetween(trigger, before, after).reason, "the coil 'C' was not followed");
}

TEST(SecondCoil, ItsTablesAreReadLikeTheFirstOnes) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  {
    auto session = std::make_shared<Session>(std::make_unique<fakes::Source>(12, 0.02), twoCoils(1000, 8),
                                             SessionOptions{});
    TreatmentLog log(session, folder.path());
    place = log.folder();
    session->start();
    while (!session->hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const auto first = casefile::readPoses(place / "poses.csv"),
             second = casefile::readPoses(place / "poses_coil2.csv");
  EXPECT_EQ(first.size(), second.size());
  int tracked = 0;
  for (const auto& row : second)
    if (row.object == casefile::PoseObject::coil && row.pose) {
      ++tracked;
      EXPECT_LT((row.pose->matrix() - kSecond.matrix()).norm(), 1e-5);
      EXPECT_LT(row.frame, 8);
    }
  EXPECT_GT(tracked, 4);
  std::ifstream guidance(place / "guidance_coil2.csv");
  std::string header, line;
  std::getline(guidance, header);
  std::getline(guidance, line);
  EXPECT_THAT(header, ::testing::EndsWith(",coil"));
  EXPECT_THAT(line, HasSubstr("other spot"));
  EXPECT_THAT(line, ::testing::EndsWith(",B"));
}

}  // namespace
}  // namespace facenav::session
