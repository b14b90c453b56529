// A camera is away for a while in the middle of a session: no pose is shown meanwhile, the reason is
// reported, and the head is shown again once its registration was checked.

#include <gmock/gmock.h>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/session/treatment_log.h"
#include "session_fakes.h"
#include "support/test_data.h"

namespace facenav::session {
namespace {

using ::testing::HasSubstr;
using Verdict = monitoring::DriftFinding::Verdict;

const RigidTransform<Camera, Marker> kAwayMarker(Eigen::Quaterniond::Identity(), {20, -60, 550});

std::shared_ptr<const cameras::StereoFrame> awayFrame(std::int64_t number, double captured_s) {
  auto f = std::make_shared<cameras::StereoFrame>();
  f->number = number;
  f->captured = {captured_s};
  f->absence = "the camera was unplugged: Webcam (/dev/video2)";
  return f;
}

std::unique_ptr<Navigator> awayNavigator(std::shared_ptr<Verdict> verdict) {
  auto navigator = std::make_unique<Navigator>(
      fakes::setup(), std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
      std::make_unique<fakes::Coil>(kAwayMarker));
  navigator->setTarget(fakes::targetAt(kAwayMarker.reframe<Camera, Coil>()));
  navigator->setCheck(std::make_unique<monitoring::RegistrationCheck>(
      [verdict](const cameras::StereoFrame&, const RigidTransform<Camera, Mri>&) {
        monitoring::DriftFinding finding;
        finding.verdict = *verdict;
        return finding;
      },
      monitoring::DriftWatchdog::Mode::in_line));
  return navigator;
}

TEST(CameraAway, NothingIsShownUntilItIsBackAndTheRegistrationWasChecked) {
  const auto verdict = std::make_shared<Verdict>(Verdict::unknown);
  const auto navigator = awayNavigator(verdict);
  ASSERT_TRUE(navigator->process(fakes::frame(0, 0.0)).camera_T_mri);
  const auto away = navigator->process(awayFrame(1, 0.02));
  EXPECT_FALSE(away.camera_T_mri);
  EXPECT_FALSE(away.camera_T_coil);
  EXPECT_FALSE(away.guidance.values);
  EXPECT_TRUE(isCameraAway(away));
  EXPECT_EQ(away.camera_T_mri.reason(), LostReason::camera);
  EXPECT_EQ(lossWord(away), "camera_away");
  EXPECT_THAT(lossInWords(away), HasSubstr("CAMERA AWAY"));
  EXPECT_THAT(rigFault(away)->words(), HasSubstr("/dev/video2"));
  for (int i = 2; i < 60; ++i) {
    const auto back = navigator->process(fakes::frame(i, 0.1 * i));
    EXPECT_FALSE(back.camera_T_mri) << "not checked yet, frame " << i;
    EXPECT_FALSE(isCameraAway(back));
  }
  *verdict = Verdict::agrees;
  NavigationState last;
  for (int i = 60; i < 180; ++i) last = navigator->process(fakes::frame(i, 0.1 * i));
  EXPECT_TRUE(last.camera_T_mri);
  EXPECT_TRUE(!last.withheld);
}

/// Source whose frames 20 to 39 have no pictures.
class GapSource : public fakes::Source {
 public:
  GapSource() : Source(200, 0.02) {}
  std::shared_ptr<const cameras::StereoFrame> next() override {
    auto frame = Source::next();
    const bool is_away = frame && frame->number >= 20 && frame->number < 40;
    return is_away ? awayFrame(frame->number, frame->captured.s) : frame;
  }
};

TEST(CameraAway, TheLogSaysItOnceAndThatItIsBack) {
  const testing::TemporaryFolder folder;
  const auto session =
      std::make_shared<Session>(std::make_unique<GapSource>(),
                                awayNavigator(std::make_shared<Verdict>(Verdict::agrees)), SessionOptions{});
  std::filesystem::path kept;
  {
    TreatmentLog log(session, folder.path());
    kept = log.folder();
    session->start();
    for (int i = 0; i < 1000 && !session->hasEnded(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::string events;
  for (const auto& event : casefile::readSession(kept).events)
    events += event.event + ": " + event.detail + "\n";
  EXPECT_THAT(events, HasSubstr("fault: the camera was unplugged: Webcam (/dev/video2)\n"));
  EXPECT_THAT(events, HasSubstr("cameras back: after 0.4 s\n"));
  EXPECT_EQ(events.find("fault"), events.rfind("fault")) << events;
  for (const auto& row : casefile::readPoses(kept / "poses.csv"))
    if (row.frame >= 20 && row.frame < 40) {
      EXPECT_FALSE(row.pose) << "frame " << row.frame;
    }
}

/// The source is a kept rig that has moved (setup/verified_cameras.h).
TEST(CamerasThatMoved, PicturesWhoseSourceKnowsAFaultShowNoPose) {
  const auto navigator = awayNavigator(std::make_shared<Verdict>(Verdict::agrees));
  ASSERT_TRUE(navigator->process(fakes::frame(0, 0.0)).camera_T_mri);
  auto frame = std::make_shared<cameras::StereoFrame>(*fakes::frame(1, 0.02));
  frame->rig_fault = "the cameras have moved; repair it";
  const auto doubted = navigator->process(frame);
  EXPECT_FALSE(doubted.head);
  EXPECT_FALSE(doubted.camera_T_mri);
  EXPECT_FALSE(doubted.camera_T_coil);
  EXPECT_FALSE(doubted.guidance.values);
  EXPECT_EQ(lossWord(doubted), "cameras_moved");
  EXPECT_THAT(lossInWords(doubted), HasSubstr("CAMERAS MOVED"));
  EXPECT_EQ(rigFault(doubted)->words(), "the cameras have moved; repair it");
  EXPECT_TRUE(doubted.images) << "the pictures can still be shown";
  EXPECT_TRUE(navigator->process(fakes::frame(2, 0.04)).camera_T_mri) << "the marker has cleared it";
}

}  // namespace
}  // namespace facenav::session
