#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>
#include <future>
#include <mutex>
#include <set>
#include <thread>

#include "facenav/scene/display.h"
#include "shell/main_window.h"
#include "shell/scene_view.h"
#include "treat/camera_row.h"
#include "treat/figures_panel.h"
#include "treat/treat_workspace.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;

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
  // An overlay is being drawn meanwhile.
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
