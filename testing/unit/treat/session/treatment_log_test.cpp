#include "facenav/session/treatment_log.h"

#include <gmock/gmock.h>

#include <atomic>
#include <fstream>
#include <set>

#include "facenav/casefile/evidence.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/casefile/session_pulses.h"
#include "facenav/casefile/twitches.h"
#include "session_fakes.h"
#include "support/test_data.h"

namespace facenav::session {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kFrames = 60, kLostFrom = 48, kLostTo = 52;

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::shared_ptr<Session> session(int frames = kFrames) {
  const RigidTransform<Camera, Marker> marker(Eigen::Quaterniond::Identity(), {0, 0, 500});
  auto navigator = std::make_unique<Navigator>(
      fakes::setup(), std::make_unique<fakes::Head>([](std::int64_t n) {
        return n >= kLostFrom && n < kLostTo ? std::nullopt : std::optional(RigidTransform<Camera, Head>());
      }),
      std::make_unique<fakes::Coil>(marker));
  navigator->setTarget(fakes::targetAt(marker.reframe<Camera, Coil>()));
  return std::make_shared<Session>(std::make_unique<fakes::Source>(frames, 0.02), std::move(navigator),
                                   SessionOptions{});
}

TEST(TreatmentLog, KeepsPosesGuidanceLossesAndPulses) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  {
    auto running = session();
    TreatmentLog log(running, folder.path());
    place = log.folder();
    log.addEvent("override", "B. C.: emergency");
    running->start();
    while (running->latest()->frame < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    log.addPulse();
    log.addPulse();  // a bounce of the key
    while (!running->hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(log.pulses(), 1);
    EXPECT_EQ(log.failure(), "");
    log.addPulse({"pedal"});  // after the recording's end
  }
  const auto pulses = casefile::readSessionPulses(place).pulses;
  ASSERT_EQ(pulses.size(), 2u);
  EXPECT_EQ(pulses[0].pulse.status, casefile::PulseStatus::on_target) << pulses[0].pulse.reason;
  EXPECT_EQ(pulses[0].pulse.target->name, "spot");
  EXPECT_EQ(pulses[1].pulse.status, casefile::PulseStatus::lost);
  const auto rows = casefile::readPoses(place / "poses.csv");
  ASSERT_FALSE(rows.empty());
  int lost_heads = 0;
  for (const auto& row : rows)
    lost_heads += row.object == casefile::PoseObject::head && row.reason.has_value();
  EXPECT_GT(lost_heads, 0);
  EXPECT_LE(lost_heads, kLostTo - kLostFrom + 1);  // the blanked last state may add one
  const std::string events = contentOf(place / "events.jsonl");
  for (const char* word : {"session started", "override", "emergency", "face found", "face lost", "no_face",
                           "coil found", "double trigger", "recording ended", "session ended"})
    EXPECT_THAT(events, HasSubstr(word));
  EXPECT_EQ(events.find("recording ended"), events.rfind("recording ended")) << "an event happens once";
  EXPECT_LT(events.find("recording ended"), events.find("session ended"));
  EXPECT_THAT(contentOf(place / "guidance.csv"), HasSubstr("spot"));
}

TEST(TreatmentLog, AFolderThatIsRemovedIsSaidAndTheSessionAndItsPulsesGoOn) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  {
    auto running = session(100 * kFrames);  // it is stopped below
    TreatmentLog log(running, folder.path());
    place = log.folder();
    running->start();
    log.addPulse();
    while (log.pulses() < 1) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    fakes::removeAll(folder.path() / "sessions");
    while (log.failure().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_THAT(log.failure(), HasSubstr("removed"));
    const auto frame = running->latest()->frame;
    log.addPulse({"pedal"});
    while (log.pulses() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    while (running->latest()->frame < frame + 5) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    running->stop();
  }
  EXPECT_EQ(casefile::readSessionPulses(place).pulses.size(), 2u);
}

TEST(TreatmentLog, ARemovedFolderIsNamedAsRemovedWhicheverFileIsWrittenFirst) {
  const testing::TemporaryFolder folder;
  auto running = session();
  TreatmentLog log(running, folder.path());
  fakes::removeAll(folder.path() / "sessions");
  // Before the first frame only times.json is written.
  for (int i = 0; i < 100 && log.failure().empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  running->start();
  while (log.failure().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_THAT(log.failure(), HasSubstr("removed"));
}

/// The writing thread is blocked for most of the session, as by a disk that does not respond.
TEST(TreatmentLog, ADiskThatStallsLosesNeitherAPulseNorAFrame) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  TreatmentLogOptions options;
  std::atomic<bool> stalls{false};
  options.clock = [&] {
    if (stalls.exchange(false)) std::this_thread::sleep_for(std::chrono::milliseconds(700));
    return std::chrono::system_clock::now();
  };
  {
    auto running = session();
    TreatmentLog log(running, folder.path(), nullptr, options);
    place = log.folder();
    running->start();
    while (running->latest()->frame < 5) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    stalls = true;
    while (stalls) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    log.addPulse();
    while (!log.lastPulse()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(log.lastPulse()->status, casefile::PulseStatus::on_target) << log.lastPulse()->reason;
    while (!running->hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  std::set<std::int64_t> frames;
  for (const auto& row : casefile::readPoses(place / "poses.csv")) frames.insert(row.frame);
  EXPECT_GE(frames.size(), std::size_t(kFrames - 3)) << "a busy computer may leave out some";
}

TEST(TreatmentLog, ARecordingThatIsStoppedHasNotEnded) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  {
    auto running = session();
    TreatmentLog log(running, folder.path());
    place = log.folder();
    running->start();
    running->stop();
  }
  EXPECT_THAT(contentOf(place / "events.jsonl"), HasSubstr("session ended"));
  EXPECT_THAT(contentOf(place / "events.jsonl"), Not(HasSubstr("recording ended")));
}

TEST(TreatmentLog, PulsesInAPauseAreKeptMarkedAndNeverOnTarget) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  double paused_s = 0;
  {
    auto running = session();
    TreatmentLog log(running, folder.path());
    place = log.folder();
    running->start();
    while (running->latest()->frame < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    log.addPulse({"a"});
    const Timestamp begin = Timestamp::now();
    log.pause("coil too warm");
    log.pause("again");  // nothing: it is paused
    EXPECT_EQ(log.pauses().reason(), "coil too warm");
    const double held_s = log.treated_s();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    log.addPulse({"b"});
    EXPECT_NEAR(log.treated_s(), held_s, 0.1) << "the clock holds";
    log.resume();
    paused_s = Timestamp::now() - begin;
    log.addPulse({"c"});
    while (log.pulses() < 3) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(log.counts().on_target, 2);
    EXPECT_EQ(log.counts().outside, 1);
  }
  const auto pulses = casefile::readSessionPulses(place).pulses;
  ASSERT_EQ(pulses.size(), 3u);
  EXPECT_FALSE(pulses[0].pulse.is_in_pause);
  EXPECT_TRUE(pulses[1].pulse.is_in_pause);
  EXPECT_EQ(pulses[1].pulse.reason, "given in a pause");
  EXPECT_TRUE(pulses[1].pulse.mri_T_coil()) << "its pose is kept";
  EXPECT_FALSE(pulses[2].pulse.is_in_pause);
  EXPECT_THAT(contentOf(place / "events.jsonl"), HasSubstr("\"pause\",\"detail\":\"coil too warm\""));
  const auto times = casefile::readSessionTimes(place);
  ASSERT_TRUE(times);
  EXPECT_NEAR(times->paused_s, paused_s, 0.1);
  EXPECT_NEAR(times->guided.total_s(), times->running_s - times->paused_s, 0.15);
}

TEST(TreatmentLog, OneAnswerAPulseAndOneThatIsTakenBackCanBeGivenAgain) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  {
    auto running = session();
    TreatmentLog log(running, folder.path());
    place = log.folder();
    running->start();
    while (running->latest()->frame < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(log.openPulse());
    EXPECT_FALSE(log.answerPulse(true)) << "there is no pulse";
    PulseTrigger trigger{"a"};
    trigger.intensity_pct = 48;
    log.addPulse(trigger);
    ASSERT_TRUE(log.openPulse());
    EXPECT_EQ(log.openPulse()->number, 1);
    EXPECT_DOUBLE_EQ(log.openPulse()->intensity_pct.value(), 48);
    EXPECT_TRUE(log.answerPulse(true));
    EXPECT_FALSE(log.answerPulse(true)) << "a bounced key";
    EXPECT_FALSE(log.answerPulse(120.0));
    EXPECT_TRUE(log.takeBackAnswer());
    EXPECT_TRUE(log.answerPulse(120.0));
    log.addPulse({"b"});
    EXPECT_TRUE(log.answerPulse(true));
    EXPECT_TRUE(log.takeBackAnswer());
  }
  EXPECT_TRUE(casefile::readTwitches(place).empty()) << "both were taken back";
  EXPECT_DOUBLE_EQ(casefile::readSessionPulses(place).pulses[0].pulse.mep_uv.value(), 120);
}

TEST(TreatmentLog, TimeInWhichTheProgramDidNotRunIsNeitherGuidedNorRunning) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place, second;
  const auto play = [&](const std::filesystem::path& goes_on) {
    auto running = session();
    TreatmentLog log(running, folder.path(), nullptr, {{}, goes_on});
    place = log.folder();
    running->start();
    while (!running->hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  play({});
  const auto once = casefile::readSession(place);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  play(place);
  const auto twice = casefile::readSession(place);
  EXPECT_NEAR(*twice.duration_s, 2 * *once.duration_s, 0.3);
  EXPECT_NEAR(twice.guided->total_s(), 2 * once.guided->total_s(), 0.3);
  EXPECT_NEAR(twice.guided->lost_s, 2 * 0.02 * (kLostTo - kLostFrom), 0.1);
  EXPECT_GT(*twice.away_s, 1.3);
}

TEST(TreatmentLog, AnEndThatNobodyAskedForIsSaid) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  {
    auto running = session();
    TreatmentLog log(running, folder.path());
    place = log.folder();
    running->start();
    running->stop();
    log.endWith("the window was closed");
  }
  EXPECT_THAT(contentOf(place / "events.jsonl"), HasSubstr("\"detail\":\"the window was closed\""));
}

TEST(TreatmentLog, KeepsTheSessionThatItsThreadReads) {
  const testing::TemporaryFolder folder;
  auto running = session();
  const std::weak_ptr<Session> seen = running;
  {
    const TreatmentLog log(running, folder.path());
    running.reset();
    EXPECT_FALSE(seen.expired());
  }
  EXPECT_TRUE(seen.expired());
}

TEST(TreatmentLog, IsRefusedWhereTheCaseCannotBeWritten) {
  const testing::TemporaryFolder folder;
  auto idle = session();
  EXPECT_THROW(TreatmentLog(idle, folder.path() / "nowhere"), Error);
}

/// A session that is played to its end with one pulse at the key and two by a pedal.
void playOnce(const std::filesystem::path& case_folder, const std::filesystem::path& goes_on,
              std::filesystem::path& place) {
  auto running = session();
  TreatmentLog log(running, case_folder, nullptr, {fakes::rig(), goes_on});
  place = log.folder();
  running->start();
  while (running->latest()->frame < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  log.addPulse();
  log.addPulse({"pedal"});
  while (!running->hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  log.addPulse({"pedal"});  // after the end: without a frame
}

TEST(TreatmentLog, ASessionThatGoesOnCountsItsPulsesAndFramesOn) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place, second;
  playOnce(folder.path(), {}, place);
  playOnce(folder.path(), place, second);
  EXPECT_EQ(place, second);
  const auto pulses = casefile::readSessionPulses(place).pulses;
  ASSERT_EQ(pulses.size(), 6u);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(pulses[std::size_t(i)].pulse.number, i + 1);
  ASSERT_TRUE(pulses[3].pulse.frames && pulses[3].pulse.t_s);
  EXPECT_GE((*pulses[3].pulse.frames)[0], kFrames) << "the second run's frames follow the first one's";
  EXPECT_GT(*pulses[3].pulse.t_s, 0.02 * kFrames + 1);
  const auto rows = casefile::readPoses(place / "poses.csv");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_GE(rows[i].frame, rows[i - 1].frame);
    EXPECT_GE(rows[i].t_s, rows[i - 1].t_s);
  }
  EXPECT_THAT(contentOf(place / "events.jsonl"), HasSubstr("after 3 pulses"));
}

TEST(TreatmentLog, BothPicturesOfEachPulsesFrameAreKept) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  playOnce(folder.path(), {}, place);
  playOnce(folder.path(), place, place);
  int with_pictures = 0;
  for (const auto& reviewed : casefile::readSessionPulses(place).pulses)
    with_pictures += casefile::evidenceFrame(place, reviewed.pulse).has_value();
  EXPECT_EQ(with_pictures, 4) << "two of six pulses came after the last frame";
}

TEST(EvidenceKeeper, HasThePicturesOfTheWaitForAFrameAtSixtyFramesASecond) {
  constexpr int kNewest = 100, kWait = int(60 * kLongestWait_s);
  const testing::TemporaryFolder folder;
  EvidenceKeeper keeper(folder.path(), fakes::rig());
  NavigationState state;
  for (state.frame = 0; state.frame <= kNewest; ++state.frame) {
    state.captured = {double(state.frame) / 60};
    state.images = fakes::frame(state.frame, state.captured.s);
    keeper.follow(state);
  }
  casefile::Pulse pulse;
  pulse.frames = {kNewest - kWait, kNewest - kWait + 1};
  keeper.add(pulse);
  for (int i = 0; i < 1000 && keeper.kept() == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(keeper.kept(), 1) << keeper.failure();
  EXPECT_EQ(keeper.leftOut(), 0);
}

TEST(TreatmentLog, APictureFolderThatCannotBeMadeIsSaidAndPulsesAreKept) {
  const testing::TemporaryFolder folder;
  std::filesystem::path place;
  {
    auto running = session();
    TreatmentLog log(running, folder.path(), nullptr, {fakes::rig(), {}});
    place = log.folder();
    std::ofstream(casefile::evidenceFolder(place)) << "a file in the folder's place";
    running->start();
    while (running->latest()->frame < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    log.addPulse();
    while (!running->hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(casefile::readSessionPulses(place).pulses.size(), 1u);
  EXPECT_THAT(contentOf(place / "events.jsonl"), HasSubstr("pulse pictures"));
}

}  // namespace
}  // namespace facenav::session
