#include "facenav/session/pulse_keeper.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "facenav/casefile/kept_session.h"
#include "facenav/session/treatment_log.h"
#include "session_fakes.h"
#include "support/test_data.h"

namespace facenav::session {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using casefile::PulseStatus;
using ::testing::HasSubstr;

const RigidTransform<Camera, Marker> kMarker(Eigen::Quaterniond::Identity(), {20, -60, 550});

template <class Condition>
bool waitFor(Condition condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(5ms);
  return condition();
}

NavigationState stateAt(std::int64_t frame, double taken_s) {
  NavigationState state;
  state.frame = frame;
  state.captured = {taken_s - 1000.0};
  state.taken = {taken_s};
  state.camera_T_mri = {fakes::cameraAtReference(), 0.9};
  state.camera_T_coil = {kMarker.reframe<Camera, facenav::Coil>(), 0.9};
  state.chosen =
      std::make_shared<const ChosenTarget>(fakes::targetAt(kMarker.reframe<Camera, facenav::Coil>()));
  return state;
}

PulseTrigger triggerAt(double at_s, const std::string& source = "keyboard") {
  PulseTrigger trigger;
  trigger.at = {at_s};
  trigger.source = source;
  return trigger;
}

std::vector<casefile::ReviewedPulse> pulsesIn(const fs::path& folder) {
  return casefile::readSessionPulses(folder).pulses;
}

TEST(PulseKeeper, APulseWaitsForTheFrameAfterIt) {
  const testing::TemporaryFolder folder;
  PulseKeeper keeper(folder.path());
  const double now_s = Timestamp::now().s;
  keeper.follow(stateAt(1, now_s));
  EXPECT_TRUE(keeper.add(triggerAt(now_s + 0.01)));
  EXPECT_EQ(keeper.waiting(), 1);
  keeper.follow(stateAt(2, now_s + 0.04));
  ASSERT_TRUE(waitFor([&] { return keeper.kept() == 1; }));
  EXPECT_EQ(keeper.waiting(), 0);
  const auto pulses = pulsesIn(folder.path());
  ASSERT_EQ(pulses.size(), 1u);
  EXPECT_EQ(pulses[0].pulse.status, PulseStatus::on_target);
  EXPECT_NEAR(pulses[0].pulse.fraction, 0.25, 1e-6);
}

TEST(PulseKeeper, NoFrameAfterItMakesItLostAfterHalfASecond) {
  const testing::TemporaryFolder folder;
  PulseKeeper keeper(folder.path());
  const double now_s = Timestamp::now().s;
  keeper.follow(stateAt(1, now_s));
  keeper.add(triggerAt(now_s + 0.001));
  ASSERT_TRUE(waitFor([&] { return keeper.kept() == 1; }));
  EXPECT_GE(Timestamp::now().s - now_s, kLongestWait_s);
  EXPECT_EQ(pulsesIn(folder.path())[0].pulse.status, PulseStatus::lost);
}

TEST(PulseKeeper, AFrameThatArrivesLateStillPlacesThePulse) {
  const testing::TemporaryFolder folder;
  PulseKeeper keeper(folder.path());
  const double now_s = Timestamp::now().s;
  keeper.follow(stateAt(1, now_s));
  keeper.add(triggerAt(now_s + 0.02));
  std::this_thread::sleep_for(150ms);  // slow cameras, and their latency
  EXPECT_EQ(keeper.waiting(), 1);
  keeper.follow(stateAt(2, now_s + 0.22));
  ASSERT_TRUE(waitFor([&] { return keeper.kept() == 1; }));
  const auto pulse = pulsesIn(folder.path())[0].pulse;
  EXPECT_EQ(pulse.status, PulseStatus::on_target) << pulse.reason;
  EXPECT_NEAR(pulse.fraction, 0.02 / 0.22, 1e-6);
}

TEST(PulseKeeper, ASecondTriggerOfOneSourceWithinItsDeadTimeIsNoPulse) {
  const testing::TemporaryFolder folder;
  PulseKeeper keeper(folder.path());
  EXPECT_TRUE(keeper.add(triggerAt(100.0)));
  EXPECT_FALSE(keeper.add(triggerAt(100.1)));
  EXPECT_TRUE(keeper.add(triggerAt(100.1, "pedal"))) << "another source";
  EXPECT_TRUE(keeper.add(triggerAt(100.16))) << "0.15 s after the one that counted";
  PulseTrigger train = triggerAt(100.2, "line");
  train.dead_time_s = 0.03;
  EXPECT_TRUE(keeper.add(train));
  train.at = {100.25};
  EXPECT_TRUE(keeper.add(train)) << "20 Hz needs a shorter dead time";
  EXPECT_TRUE(waitFor([&] { return keeper.kept() == 5; }));
  EXPECT_EQ(pulsesIn(folder.path()).size(), 5u);
}

TEST(PulseKeeper, ATriggerDatedFarBackIsAPulseAndOneALittleOutOfOrderIsNone) {
  const testing::TemporaryFolder folder;
  PulseKeeper keeper(folder.path());
  EXPECT_TRUE(keeper.add(triggerAt(100.0)));
  EXPECT_FALSE(keeper.add(triggerAt(99.9))) << "the same pulse, out of order";
  EXPECT_TRUE(keeper.add(triggerAt(40.0))) << "the source's clock has jumped back";
  EXPECT_TRUE(keeper.add(triggerAt(41.0))) << "and so do all that follow";
  EXPECT_FALSE(keeper.add(triggerAt(41.1)));
  EXPECT_EQ(keeper.added(), 3);
}

TEST(PulseKeeper, WhatStillWaitsIsKeptAtTheEnd) {
  const testing::TemporaryFolder folder;
  {
    PulseKeeper keeper(folder.path());
    for (int i = 0; i < 10; ++i) keeper.add(triggerAt(100.0 + i));
  }
  EXPECT_EQ(pulsesIn(folder.path()).size(), 10u);
}

TEST(PulseKeeper, WhatCannotBeWrittenIsSaidAndKeptAsSoonAsItCan) {
  const testing::TemporaryFolder folder;
  const fs::path session = folder.path() / "case/sessions/now", gone = folder.path() / "gone";
  fs::create_directories(session);
  PulseKeeper keeper(session);
  keeper.add(triggerAt(100.0));
  ASSERT_TRUE(waitFor([&] { return keeper.kept() == 1; }));
  fs::remove_all(folder.path() / "case");
  std::ofstream(folder.path() / "case") << "in the way";
  keeper.add(triggerAt(101.0));
  keeper.add(triggerAt(102.0));
  ASSERT_TRUE(waitFor([&] { return !keeper.failure().empty(); }));
  EXPECT_EQ(keeper.kept(), 1);
  EXPECT_EQ(keeper.waiting(), 2);
  fs::remove(folder.path() / "case");
  fs::create_directories(folder.path() / "case");
  ASSERT_TRUE(waitFor([&] { return keeper.kept() == 3; }));
  EXPECT_EQ(keeper.failure(), "");
  const auto pulses = pulsesIn(session);
  ASSERT_EQ(pulses.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(pulses[std::size_t(i)].pulse.number, i + 1);
}

/// Runs a session with pulses at 50 Hz, each from a source of its own, and reports how many are stored. Ends
/// with the process.
[[noreturn]] void treatWithoutEnd(const fs::path& case_folder, int said) {
  auto navigator = std::make_unique<Navigator>(
      fakes::setup(), std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
      std::make_unique<fakes::Coil>(kMarker));
  navigator->setTarget(fakes::targetAt(kMarker.reframe<Camera, facenav::Coil>()));
  auto session = std::make_shared<Session>(std::make_unique<fakes::Source>(1000000, 0.01),
                                           std::move(navigator), SessionOptions{});
  TreatmentLog log(session, case_folder);
  session->start();
  for (int number = 1;; ++number) {
    log.addPulse({"key " + std::to_string(number)});
    std::this_thread::sleep_for(20ms);
    const int kept = log.pulses();
    if (::write(said, &kept, sizeof kept) != sizeof kept) ::_exit(1);
  }
}

TEST(PulseKeeper, ASessionKilledAtAnyMomentHasEveryPulseThatItShowed) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> pulses_before(0, 8), later_ms(0, 25);
  int shown_in_all = 0;
  for (int death = 0; death < 20; ++death) {
    const testing::TemporaryFolder folder;
    int said[2];
    ASSERT_EQ(::pipe(said), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) treatWithoutEnd(folder.path(), said[1]);
    ::close(said[1]);
    const int wanted = pulses_before(random);
    int shown = -1;
    const auto hear = [&] { return ::read(said[0], &shown, sizeof shown) == sizeof shown; };
    while (shown < wanted && hear()) continue;
    std::this_thread::sleep_for(std::chrono::milliseconds(later_ms(random)));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    while (hear()) continue;
    ::close(said[0]);
    const auto session = casefile::readSession(casefile::findSession(folder.path(), ""));
    const auto& pulses = session.pulses.pulses;
    ASSERT_GE(int(pulses.size()), shown);
    for (std::size_t i = 0; i < pulses.size(); ++i) {
      ASSERT_EQ(pulses[i].pulse.number, int(i) + 1);
      ASSERT_EQ(pulses[i].pulse.source, "key " + std::to_string(i + 1));
    }
    shown_in_all += shown;
  }
  EXPECT_GT(shown_in_all, 20);
}

}  // namespace
}  // namespace facenav::session
