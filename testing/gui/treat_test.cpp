#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>
#include <fstream>
#include <future>
#include <mutex>
#include <set>

#include "facenav/casefile/kept_session.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "main_window.h"
#include "unit/session/session_fakes.h"
#include "views/scene_view.h"
#include "widgets/camera_row.h"
#include "widgets/figures_panel.h"
#include "workspaces/treat_workspace.h"

namespace facenav::ui {
namespace {

namespace fakes = session::fakes;

const RigidTransform<Camera, Marker> kMarker(Eigen::Quaterniond::Identity(), {20, -60, 550});

/// Trackers that always see head and coil; the coil is at the planned target.
Services fakeServices() {
  Services services;
  services.align = [](const casefile::CaseStore&, const capture::Recording&, TaskMonitor&) {
    workflow::AlignmentOutcome outcome;
    outcome.result.camera_T_mri = fakes::cameraAtReference();
    outcome.reference.frame = *fakes::frame(0, 0);
    return outcome;
  };
  services.makeNavigator = [](const session::NavigatorSetup& setup) {
    return std::make_unique<session::Navigator>(
        setup, std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
        std::make_unique<fakes::Coil>(kMarker));
  };
  return services;
}

std::filesystem::path writeRecording(const std::filesystem::path& folder, int frames) {
  capture::RecordingWriter writer(folder / "recording", fakes::rig());
  for (int i = 0; i < frames; ++i) writer.add(*fakes::frame(i, i * 0.02));
  writer.close();
  return folder / "recording";
}

/// A ball case with a target under the coil; signed off on request.
std::filesystem::path plannedCase(const std::filesystem::path& folder, bool is_signed_off) {
  const auto case_folder = fixtures::writeBallCase(folder);
  guidance::TreatmentPlan plan;
  plan.targets.push_back(fakes::targetAt(kMarker.reframe<Camera, Coil>()).target);
  const auto store = casefile::CaseStore::open(case_folder);
  store.setTargets(plan);
  if (is_signed_off) casefile::signOff(store, {"XY", "", true});
  return case_folder;
}

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
    settle();  // aligned
    settle();  // started
    ASSERT_TRUE(treat_.isRunning());
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
  settle();
  settle();
  ASSERT_TRUE(treat_.isRunning());
  treat_.countPulse();
  EXPECT_TRUE(fixtures::waitFor([&] { return treat_.pulses() == 1; }));
  treat_.stop();
  for (const char* word : {"session started", "B. Clinician: emergency", "spot", "aligned: "})
    EXPECT_NE(events().find(word), std::string::npos) << word;
  const auto session = casefile::findSession(case_folder_, "");
  ASSERT_EQ(casefile::readSessionPulses(session).pulses.size(), 1u);
  EXPECT_TRUE(fixtures::waitFor([&] { return std::filesystem::exists(session / "report.html"); }));
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

/// Reports its destruction, which comes with that of its session.
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
  treat_.stop();
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

TEST(Treat, TheWindowNeitherDrawsTheCameraPicturesNorWaitsForThem) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  std::promise<void> may_draw;
  const std::shared_future<void> gate(may_draw.get_future());
  std::mutex mutex;
  std::set<std::thread::id> drew;
  const Services services = fakeServices();
  CaseModel model;
  TaskRunner tasks;
  TreatPresenter treat(services, model, tasks, nullptr, [&](const pictures::OverlayOrder& order) {
    gate.wait_for(std::chrono::seconds(20));
    const std::lock_guard lock(mutex);
    drew.insert(std::this_thread::get_id());
    return pictures::drawOverlay(order.rig, *order.state, order.target);
  });
  TreatWorkspace workspace(treat, model);
  workspace.resize(1400, 900);
  workspace.show();
  TaskMonitor monitor;
  model.open(loadCase(plannedCase(folder.path(), true), monitor));
  const auto settle = [&] { fixtures::waitFor([&] { return !tasks.isRunning(); }); };
  treat.openRecording(QString::fromStdString(writeRecording(folder.path(), 800).string()));
  settle();
  treat.align(true);
  settle();
  settle();
  const auto* figures = workspace.findChild<FiguresPanel*>();
  const auto* row = workspace.findChild<CameraRow*>();
  // While an overlay is being drawn.
  ASSERT_TRUE(fixtures::waitFor([&] { return figures->figures()[0] == "0.0"; }));
  const auto first = treat.state()->frame;
  EXPECT_TRUE(fixtures::waitFor([&] { return treat.state()->frame > first + 20; }));
  EXPECT_EQ(row->shown(), nullptr);
  may_draw.set_value();
  ASSERT_TRUE(fixtures::waitFor([&] { return row->shown() != nullptr; }));
  EXPECT_GT(row->shown()->state->frame, first) << "the picture begun long ago was too old";
  EXPECT_DOUBLE_EQ(row->shown()->captured.s, row->shown()->state->captured.s);
  treat.stop();
  const std::lock_guard lock(mutex);
  EXPECT_FALSE(drew.empty());
  EXPECT_EQ(drew.count(std::this_thread::get_id()), 0u);
}

TEST(Treat, GuidesWhileTheRecordingPlaysAndLeavesNoPoseStandingAtItsEnd) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const auto case_folder = plannedCase(folder.path(), true);
  MainWindow window(fakeServices());
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 240).string()));
  window.setWorkspace(Workspace::treat);
  auto* figures = window.findChild<FiguresPanel*>();
  ASSERT_NE(figures, nullptr);
  const QString dash(QChar(0x2013));
  ASSERT_TRUE(fixtures::waitFor([&] { return figures->figures()[0] != dash; }));
  EXPECT_EQ(figures->figures()[0], "0.0");
  SceneView* scene_view = nullptr;
  for (auto* view : window.findChildren<SceneView*>())
    if (view->isVisible()) scene_view = view;
  ASSERT_NE(scene_view, nullptr);
  EXPECT_TRUE(scene_view->scene().showsCoil());
  ASSERT_TRUE(fixtures::waitFor([&] { return figures->instruction().contains("ENDED"); }));
  EXPECT_EQ(figures->figures(), (std::array<QString, 4>{dash, dash, dash, dash}));
  EXPECT_FALSE(scene_view->scene().showsCoil());
}

TEST(Treat, HeaderAndPageTellOneTruthAboutTheAlignment) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const auto case_folder = plannedCase(folder.path(), true);
  casefile::StoredAlignment of_yesterday;
  of_yesterday.rms_mm = 0.37, of_yesterday.predicted_tre_mm["spot"] = 0.4;
  casefile::writeAlignment(of_yesterday, case_folder / "alignment.json");
  MainWindow window(fakeServices());
  window.show();
  const auto* header = window.findChild<QFrame*>("header")->findChild<QLabel*>("muted");
  const auto agree = [&] { return header->text().endsWith(window.treat().alignmentWords()); };
  window.openCase(QString::fromStdString(case_folder.string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }));
  EXPECT_TRUE(header->text().endsWith("not aligned in this session")) << header->text().toStdString();
  EXPECT_TRUE(agree());
  window.play(QString::fromStdString(writeRecording(folder.path(), 50).string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isAligned() && window.isSettled(); }));
  EXPECT_TRUE(window.treat().alignmentWords().startsWith("aligned"));
  EXPECT_TRUE(agree()) << header->text().toStdString();
}

/// The button whose tooltip names the key.
QPushButton* buttonOf(MainWindow& window, const QString& key) {
  for (auto* button : window.findChildren<QPushButton*>())
    if (button->isVisible() && button->toolTip().contains("(" + key + ")")) return button;
  return nullptr;
}

TEST(Treat, EveryKeyThatATooltipNamesWorksAndSpaceStopsGuidance) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const auto case_folder = plannedCase(folder.path(), true);
  MainWindow window(fakeServices());
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 600).string()));
  window.setWorkspace(Workspace::treat);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }));
  QApplication::setActiveWindow(&window);
  auto* cameras = buttonOf(window, "Ctrl+R");
  ASSERT_NE(cameras, nullptr);
  for (const bool is_shown : {true, false}) {
    QTest::keyClick(&window, Qt::Key_R, Qt::ControlModifier);
    EXPECT_TRUE(fixtures::waitFor([&] { return cameras->isChecked() == is_shown; }, 2000)) << is_shown;
  }
  ASSERT_EQ(window.treat().pulses(), 0);
  QTest::keyClick(&window, Qt::Key_P);
  EXPECT_TRUE(fixtures::waitFor([&] { return window.treat().pulses() == 1; }, 2000));
  QTest::qWait(200);  // past the dead time of one source
  QTest::mouseClick(buttonOf(window, "P"), Qt::LeftButton);
  EXPECT_TRUE(fixtures::waitFor([&] { return window.treat().pulses() == 2; }, 2000));
  cameras->setFocus();  // a focused button must not swallow the stop key
  QTest::keyClick(cameras, Qt::Key_Space);
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.treat().isRunning(); }, 2000));
  EXPECT_FALSE(cameras->isChecked());
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().canAlign() && !window.tasks().isRunning(); }));
  bool has_aligned = false;
  QObject::connect(&window.tasks(), &TaskRunner::started, [&] { has_aligned = true; });
  QTest::keyClick(&window, Qt::Key_L, Qt::ControlModifier);
  EXPECT_TRUE(fixtures::waitFor([&] { return has_aligned && !window.tasks().isRunning(); }, 5000));
  QTest::keyClick(&window, Qt::Key_Space);
  EXPECT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }, 5000));
}

}  // namespace
}  // namespace facenav::ui
