#include <gtest/gtest.h>

#include "facenav/session/session.h"
#include "session_fakes.h"

namespace facenav::session {
namespace {

using namespace std::chrono_literals;

const RigidTransform<Camera, Marker> kLoopMarker(Eigen::Quaterniond::Identity(), {20, -60, 550});

std::unique_ptr<Navigator> navigator(
    int work_ms, fakes::Head::Pose pose = [](auto) { return RigidTransform<Camera, Head>(); }) {
  auto n =
      std::make_unique<Navigator>(fakes::setup(), std::make_unique<fakes::Head>(std::move(pose), work_ms),
                                  std::make_unique<fakes::Coil>(kLoopMarker));
  n->setTarget(fakes::targetAt(kLoopMarker.reframe<Camera, Coil>()));
  return n;
}

void waitForEnd(const Session& session) {
  for (int i = 0; i < 2000 && !session.hasEnded(); ++i) std::this_thread::sleep_for(5ms);
  ASSERT_TRUE(session.hasEnded());
}

TEST(Session, BeforeTheFirstFrameEverythingIsStale) {
  Session session(std::make_unique<fakes::Source>(3, 0.01), navigator(0), {});
  const auto state = session.latest();
  ASSERT_NE(state, nullptr);
  EXPECT_FALSE(state->camera_T_mri);
  EXPECT_EQ(state->camera_T_mri.reason(), LostReason::stale);
  EXPECT_EQ(state->guidance.state, guidance::State::lost);
}

TEST(Session, PublishesTheLastFrameThenBlanksItWhenItIsOld) {
  SessionOptions options;
  options.age_limit_s = 0.3;
  options.is_paced = false;
  Session session(std::make_unique<fakes::Source>(5, 0.01), navigator(0), options);
  session.start();
  waitForEnd(session);
  const auto fresh = session.latest();
  EXPECT_EQ(fresh->frame, 4);
  std::this_thread::sleep_for(350ms);
  const auto old = session.latest();
  EXPECT_EQ(old->frame, 4);
  EXPECT_FALSE(old->camera_T_mri);
  EXPECT_FALSE(old->camera_T_coil);
  EXPECT_FALSE(old->guidance.values);
  EXPECT_EQ(old->guidance.state, guidance::State::lost);
  ASSERT_TRUE(old->guidance.reason);
  EXPECT_EQ(*old->guidance.reason, LostReason::stale);
}

/// Live cameras whose pictures arrive late, as from a full queue.
class LateSource : public fakes::Source {
 public:
  explicit LateSource(double late_s) : Source(5, 0.01), late_s_(late_s) {}
  std::shared_ptr<const cameras::StereoFrame> next() override {
    const auto frame = Source::next();
    return frame ? fakes::frame(frame->number, Timestamp::now().s - late_s_) : nullptr;
  }

 private:
  double late_s_;
};

TEST(Session, AnOldPictureThatArrivesNowIsStale) {
  for (const double late_s : {0.05, 1.5}) {
    SessionOptions options;
    options.age_limit_s = 0.5;
    options.is_paced = false;
    Session session(std::make_unique<LateSource>(late_s), navigator(0), options);
    session.start();
    waitForEnd(session);
    EXPECT_EQ(session.latest()->camera_T_mri.isTracked(), late_s < 1) << late_s;
  }
}

TEST(Session, OverwritesFramesThatTrackingIsTooSlowForAndCountsThem) {
  SessionOptions options;
  options.is_paced = false;  // 200 frames at once, with 20 ms of work each
  Session session(std::make_unique<fakes::Source>(200, 0.01), navigator(20), options);
  session.start();
  waitForEnd(session);
  const auto last = session.latest();
  EXPECT_EQ(last->frame, 199);  // the newest is always tracked
  EXPECT_GT(last->dropped, 150u);
}

TEST(Session, PacesARecordingByItsTimeStamps) {
  const Timestamp begin = Timestamp::now();
  Session session(std::make_unique<fakes::Source>(11, 0.02), navigator(0), {});  // 10 intervals of 20 ms
  session.start();
  waitForEnd(session);
  EXPECT_GE(Timestamp::now() - begin, 0.195);
}

TEST(Session, StopsWithinAFrameOfAnEndlessSlowSource) {
  Session session(std::make_unique<fakes::Source>(1000000, 60.0), navigator(0), {});  // a frame a minute
  session.start();
  std::this_thread::sleep_for(20ms);
  session.stop();
  session.stop();  // calling it again is harmless
  SUCCEED();
}

TEST(Session, AReadErrorReachesTheConsumerAsWordsWithoutAPose) {
  SessionOptions options;
  options.is_paced = false;
  Session session(std::make_unique<fakes::Source>(50, 0.01, 5), navigator(0), options);
  session.start();
  waitForEnd(session);
  const auto state = session.latest();
  EXPECT_NE(state->failure.find("000005.png"), std::string::npos);
  EXPECT_FALSE(state->camera_T_mri);
  EXPECT_FALSE(state->guidance.values);
}

TEST(Session, ATrackersExceptionReachesTheConsumerToo) {
  Session session(std::make_unique<fakes::Source>(50, 0.001),
                  navigator(0,
                            [](std::int64_t n) -> std::optional<RigidTransform<Camera, Head>> {
                              if (n >= 3) throw std::runtime_error("broken tracker");
                              return RigidTransform<Camera, Head>();
                            }),
                  {});
  session.start();
  waitForEnd(session);
  EXPECT_NE(session.latest()->failure.find("broken tracker"), std::string::npos);
  EXPECT_FALSE(session.latest()->camera_T_mri);
}

TEST(Session, TheClockStopsWithTheRecordingAndTheEndHasItsReason) {
  Session session(std::make_unique<fakes::Source>(6, 0.02), navigator(0), {});
  EXPECT_EQ(session.elapsed_s(), 0.0);
  EXPECT_EQ(session.end(), SessionEnd::none);
  session.start();
  waitForEnd(session);
  const double at_end_s = session.elapsed_s();
  EXPECT_GE(at_end_s, 0.095);
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(session.elapsed_s(), at_end_s);
  session.stop();  // which does not change it
  EXPECT_EQ(session.elapsed_s(), at_end_s);
  EXPECT_EQ(session.end(), SessionEnd::source);
}

TEST(Session, AStopAndAFaultAreNoEndOfTheRecording) {
  Session stopped(std::make_unique<fakes::Source>(1000, 0.02), navigator(0), {});
  stopped.start();
  stopped.stop();
  EXPECT_EQ(stopped.end(), SessionEnd::stop);
  Session failed(std::make_unique<fakes::Source>(50, 0.001, 5), navigator(0), {});
  failed.start();
  waitForEnd(failed);
  EXPECT_EQ(failed.end(), SessionEnd::fault);
}

TEST(Session, ANewTargetIsTakenUpWhileRunning) {
  Session session(std::make_unique<fakes::Source>(1000, 0.005), navigator(0), {});
  session.start();
  auto other = fakes::targetAt(kLoopMarker.reframe<Camera, Coil>());
  other.target.name = "other";
  session.setTarget(other);
  bool is_taken_up = false;
  for (int i = 0; i < 200 && !is_taken_up; ++i) {
    const auto state = session.take(100ms);
    is_taken_up = state && state->target == "other";
  }
  EXPECT_TRUE(is_taken_up);
}

}  // namespace
}  // namespace facenav::session
