#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <mutex>
#include <thread>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/error.h"
#include "facenav/links/igtl_content.h"
#include "support/free_port.h"
#include "support/igtl_client.h"
#include "treat/session_end.h"
#include "treat/treat_presenter.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;

/// The presenter alone: no window, no display.
class TreatPresenterTest : public ::testing::Test {
 protected:
  TreatPresenterTest() : services_(fakeServices()), treat_(services_, model_, tasks_) {
    QObject::connect(&tasks_, &TaskRunner::failed, [this](const QString& words) { failure_ = words; });
  }
  void openAll(bool is_signed_off, int frames = 100) {
    case_folder_ = plannedCase(folder_.path(), is_signed_off);
    TaskMonitor monitor;
    model_.open(loadCase(case_folder_, monitor));
    treat_.openRecording(QString::fromStdString(writeRecording(folder_.path(), frames).string()));
    settle();
  }
  void guide() {
    treat_.align(true);
    ASSERT_TRUE(fixtures::waitFor([&] { return treat_.isRunning(); }));
  }
  void settle() {
    fixtures::waitFor([&] { return !tasks_.isRunning(); });
  }
  std::string events() const {
    std::string all;
    for (const auto& item : std::filesystem::recursive_directory_iterator(case_folder_ / "sessions"))
      if (item.path().filename() == "events.jsonl") {
        std::ifstream file(item.path());
        all.append(std::istreambuf_iterator<char>(file), {});
      }
    return all;
  }
  testing::TemporaryFolder folder_;
  Services services_;
  CaseModel model_;
  TaskRunner tasks_;
  TreatPresenter treat_;
  std::filesystem::path case_folder_;
  QString failure_;
};

TEST_F(TreatPresenterTest, ACaseThatNobodySignedOffIsNotTreatedWithoutAnOverride) {
  openAll(false);
  treat_.align(true);
  EXPECT_FALSE(tasks_.isRunning());
  EXPECT_FALSE(treat_.isAligned());
  treat_.overrideSignOff("B. Clinician", "  ");  // an override needs a reason
  EXPECT_FALSE(treat_.mayTreat());
  treat_.overrideSignOff("B. Clinician", "emergency");
  ASSERT_TRUE(treat_.mayTreat());
  EXPECT_EQ(model_.current().store.provenance().back().step, "override");
  treat_.align(true);
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.isRunning(); }));
  treat_.countPulse();
  EXPECT_TRUE(fixtures::waitFor([&] { return treat_.pulses() == 1; }));
  treat_.end();
  for (const char* word : {"session started", "B. Clinician: emergency", "spot", "aligned: "})
    EXPECT_NE(events().find(word), std::string::npos) << word;
  const auto session = casefile::findSession(case_folder_, "");
  ASSERT_EQ(casefile::readSessionPulses(session).pulses.size(), 1u);
  EXPECT_TRUE(fixtures::waitFor([&] { return std::filesystem::exists(session / "report.html"); }));
}

TEST_F(TreatPresenterTest, PressesThatABusyWindowHandlesTogetherAreOnePulseEachAtTheirOwnTimes) {
  openAll(true, 400);
  guide();
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.state()->frame > 2; }));
  const Timestamp begin = Timestamp::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(2200));  // the window is busy
  for (const double at_s : {0.2, 0.8, 1.4, 2.0}) treat_.countPulse({begin.s + at_s});
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.pulses() == 4; }));
  treat_.end();
  const auto pulses = casefile::readSessionPulses(casefile::findSession(case_folder_, "")).pulses;
  ASSERT_EQ(pulses.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(pulses[i].pulse.steady_s, begin.s + 0.2 + 0.6 * double(i), 1e-3);
    EXPECT_TRUE(pulses[i].pulse.mri_T_coil()) << "with the pose of its own time: " << pulses[i].pulse.reason;
  }
}

TEST_F(TreatPresenterTest, StoppingGuidanceAndEndingTheSessionAreTwoThings) {
  openAll(true, 400);
  guide();
  treat_.stopGuiding();
  EXPECT_TRUE(treat_.isRunning());
  EXPECT_TRUE(treat_.isPaused());
  treat_.guide();
  EXPECT_TRUE(treat_.isGuiding());
  treat_.askEnd();
  EXPECT_TRUE(treat_.isEnding());
  EXPECT_FALSE(treat_.isGuiding()) << "nobody is guided while the end is asked for";
  EXPECT_FALSE(treat_.summary().isEmpty());
  treat_.cancelEnd();
  EXPECT_TRUE(treat_.isGuiding());
  QString ended;
  QObject::connect(&treat_, &TreatPresenter::sessionEnded, [&](const QString& name) { ended = name; });
  treat_.askEnd();
  treat_.end("4", "headache");
  EXPECT_FALSE(treat_.hasSession());
  ASSERT_TRUE(fixtures::waitFor([&] { return !ended.isEmpty(); }));
  const auto folder = casefile::findSession(case_folder_, ended.toStdString());
  std::ifstream file(folder / "report.html");
  const std::string report((std::istreambuf_iterator<char>(file)), {});
  for (const char* words : {"ended normally", "headache", "Pain after (0 to 10)</td><td>4"})
    EXPECT_NE(report.find(words), std::string::npos) << words;
}

TEST_F(TreatPresenterTest, ASessionThatAnotherCaseEndedHasNotEndedNormally) {
  openAll(true, 400);
  guide();
  TaskMonitor monitor;
  model_.open(loadCase(case_folder_, monitor));
  EXPECT_FALSE(treat_.hasSession());
  EXPECT_NE(events().find("another case was opened"), std::string::npos);
}

TEST_F(TreatPresenterTest, AnOverrideEndsWithTheCaseBeingOpenedAgain) {
  openAll(false);
  treat_.overrideSignOff("B. Clinician", "emergency");
  TaskMonitor monitor;
  model_.open(loadCase(case_folder_, monitor));
  EXPECT_FALSE(treat_.mayTreat());
}

TEST_F(TreatPresenterTest, AModelThatChangedOnDiskSinceItWasOpenedIsRefused) {
  openAll(true);
  ASSERT_TRUE(treat_.mayTreat());
  std::ofstream(case_folder_ / "scalp.vtp", std::ios::app) << " ";
  treat_.align(false);
  settle();
  EXPECT_FALSE(treat_.isAligned());
  EXPECT_TRUE(failure_.contains("not signed off"));
  EXPECT_TRUE(failure_.contains("scalp.vtp"));
}

/// Reports its destruction, which coincides with that of its session.
class WatchedHead : public fakes::Head {
 public:
  explicit WatchedHead(std::function<void()> on_gone)
      : Head([](auto) { return RigidTransform<Camera, facenav::Head>(); }), on_gone_(std::move(on_gone)) {}
  ~WatchedHead() override { on_gone_(); }

 private:
  std::function<void()> on_gone_;
};

TEST_F(TreatPresenterTest, AfterTheRecordingVanishedAndCameBackTheOldSessionEndsBeforeTheNextStarts) {
  std::mutex mutex;
  std::vector<bool> had_log_ended;  // one entry per session, at its end
  services_.makeNavigator = [&](const session::NavigatorSetup& setup) {
    return std::make_unique<session::Navigator>(
        setup, std::make_unique<WatchedHead>([&] {
          const std::lock_guard lock(mutex);
          had_log_ended.push_back(events().find("session ended") != std::string::npos);
        }),
        std::make_unique<fakes::Coil>(kMarker));
  };
  openAll(true, 600);
  guide();
  const auto recording = folder_.path() / "recording", elsewhere = folder_.path() / "elsewhere";
  std::filesystem::rename(recording, elsewhere);
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.hasEnded(); }));
  EXPECT_NE(treat_.state()->failure, "");
  treat_.start();
  settle();
  EXPECT_FALSE(treat_.isRunning());
  EXPECT_NE(failure_, "");
  std::filesystem::rename(elsewhere, recording);
  had_log_ended.clear();  // the tracker of the failed start is already destroyed
  treat_.start();
  settle();
  EXPECT_TRUE(treat_.isRunning());
  {
    const std::lock_guard lock(mutex);
    ASSERT_EQ(had_log_ended.size(), 1u);
    EXPECT_TRUE(had_log_ended[0]) << "the log still read a session that had gone";
  }
  treat_.end();
  EXPECT_TRUE(fixtures::waitFor([&] {
    const std::lock_guard lock(mutex);
    return had_log_ended.size() == 2;
  }));
  EXPECT_NE(events().find("fault"), std::string::npos);
}

TEST_F(TreatPresenterTest, WhereTheLogCannotBeWrittenNothingRunsAndItIsSaid) {
  openAll(true, 600);
  std::ofstream(case_folder_ / "sessions") << "no folder";
  treat_.align(true);
  settle();
  settle();
  EXPECT_FALSE(treat_.isRunning());
  EXPECT_NE(failure_, "");
  std::filesystem::remove(case_folder_ / "sessions");
  treat_.start();
  settle();
  EXPECT_TRUE(treat_.isRunning());
}

TEST_F(TreatPresenterTest, TheSessionClockStopsWithTheRecordingWhichIsAnEvent) {
  openAll(true, 50);
  EXPECT_EQ(treat_.sessionTime(), "");
  guide();
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.hasEnded(); }));
  const QString at_end = treat_.sessionTime();
  fixtures::waitFor([] { return false; }, 1300);  // the clock shows whole seconds
  EXPECT_EQ(treat_.sessionTime(), at_end);
  EXPECT_NE(events().find("recording ended"), std::string::npos);
}

TEST(SessionEnd, AnEndThatFailsLetsTheReportAndTheWindowGoOn) {
  std::atomic<bool> is_reported{false};
  {
    AsynchronousShutdown retirement;
    endBeside(
        retirement, [] { throw Error("the disk is full"); }, [&] { is_reported = true; });
  }  // waits for both
  EXPECT_TRUE(is_reported);
}

TEST_F(TreatPresenterTest, PosesAreServedWhileTheSwitchIsOn) {
  openAll(true, 400);
  EXPECT_FALSE(treat_.isSending());
  const int port = testing::freePort();
  ASSERT_TRUE(treat_.sendTo("igtl:" + QString::number(port)));
  testing::LoopbackClient client(port);
  EXPECT_TRUE(fixtures::waitFor([&] { return treat_.receivers().size() == 1; }));
  client.ask("GET_POLYDATA", "Scalp");
  const auto scalp = client.next("POLYDATA");
  ASSERT_TRUE(scalp);
  EXPECT_GT(links::readSurface(scalp->content)->triangles.size(), 100u);
  guide();
  const auto coil = client.nextPose("Coil1ToTracker");
  ASSERT_TRUE(coil);
  EXPECT_LT((links::readTransform(coil->content)->matrix() - kMarker.matrix()).norm(), 1e-4);
  EXPECT_TRUE(client.nextPose("CoilToTarget"));
  const QString server = "igtl:" + QString::number(port), others = "json:9, osc:9";
  ASSERT_TRUE(treat_.sendTo(server + " " + others));
  EXPECT_EQ(treat_.sendsTo(), (QStringList{server, "json:9", "osc:9"}));
  EXPECT_TRUE(client.nextPose("CoilToTarget")) << "what was open stays open";
  EXPECT_TRUE(treat_.setOtherOutputs(others));
  EXPECT_FALSE(treat_.setOtherOutputs("json:9, osc:nowhere"));
  EXPECT_EQ(treat_.otherOutputs(), others) << "remembered";
  EXPECT_TRUE(treat_.sendTo({}));
  EXPECT_FALSE(treat_.isSending());
  EXPECT_TRUE(client.isClosed());
  EXPECT_TRUE(treat_.isRunning());
  EXPECT_FALSE(treat_.sendTo("osc:nowhere"));
}

}  // namespace
}  // namespace facenav::ui
