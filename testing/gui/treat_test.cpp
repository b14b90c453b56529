#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTextBrowser>
#include <QtTest/QTest>
#include <algorithm>
#include <future>
#include <mutex>
#include <set>
#include <thread>

#include "facenav/casefile/kept_session.h"
#include "facenav/scene/display.h"
#include "shell/elided_label.h"
#include "shell/main_window.h"
#include "shell/scene_view.h"
#include "treat/camera_row.h"
#include "treat/figures_panel.h"
#include "treat/treat_workspace.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;

/// Opens a planned case and a recording, and aligns it: its session runs from then on.
void runAligned(TreatPresenter& treat, CaseModel& model, TaskRunner& tasks,
                const std::filesystem::path& folder, int frames) {
  TaskMonitor monitor;
  model.open(loadCase(plannedCase(folder, true), monitor));
  const auto settle = [&] { fixtures::waitFor([&] { return !tasks.isRunning(); }); };
  treat.openRecording(QString::fromStdString(writeRecording(folder, frames).string()));
  settle();
  treat.align(true);
  settle();
  settle();
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
  runAligned(treat, model, tasks, folder.path(), 800);
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
  treat.end();
  const std::lock_guard lock(mutex);
  EXPECT_FALSE(drew.empty());
  EXPECT_EQ(drew.count(std::this_thread::get_id()), 0u);
}

TEST(Treat, TheCameraPicturesAreShownHoweverSlowlyTheSceneIsRendered) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const Services services = fakeServices();
  CaseModel model;
  TaskRunner tasks;
  TreatPresenter treat(services, model, tasks);
  TreatWorkspace workspace(treat, model);
  workspace.resize(1400, 900);
  workspace.show();
  runAligned(treat, model, tasks, folder.path(), 800);
  ASSERT_TRUE(fixtures::waitFor([&] { return treat.isRunning(); }));
  const auto* row = workspace.findChild<CameraRow*>();
  int drawn = 0, shown = 0, scenes = 0;
  QObject::connect(&treat, &TreatPresenter::overlayDrawn, &workspace,
                   [&](const auto& picture) { ++drawn, shown += row->shown() == picture; });
  vtkNew<vtkCallbackCommand> slowly;
  slowly->SetClientData(&scenes);
  slowly->SetCallback([](vtkObject*, unsigned long, void* count, void*) {
    ++*static_cast<int*>(count);
    QTest::qSleep(300);  // longer than the age limit of a pose
  });
  workspace.findChild<SceneView*>()->scene().renderer()->AddObserver(vtkCommand::StartEvent, slowly);
  EXPECT_TRUE(fixtures::waitFor([&] { return shown >= 8 && scenes >= 3; }))
      << drawn << " drawn, " << shown << " shown";
  EXPECT_GT(drawn, scenes) << "pictures are drawn while the scene rests";
  treat.end();
}

TEST(Treat, AFaceThatIsTooCoarseIsAlignedOnlyAfterAPersonConfirmsThePatient) {
  testing::TemporaryFolder folder;
  Services services = fakeServices();
  services.align = [plain = services.align](const auto& store, const auto& recording, const auto& known,
                                            auto& task) {
    if (!known.is_patient_confirmed)
      throw registration::PersonUnclear("not aligned: too coarse", "come nearer");
    return plain(store, recording, known, task);
  };
  MainWindow window(services);
  window.show();
  window.openCase(QString::fromStdString(plannedCase(folder.path(), true).string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 60).string()), false);
  window.setWorkspace(Workspace::treat);
  const auto question = [&] {
    for (auto* box : window.findChildren<QMessageBox*>("person_question"))
      if (box->isVisible()) return box;
    return static_cast<QMessageBox*>(nullptr);
  };
  ASSERT_TRUE(fixtures::waitFor([&] { return question() != nullptr; }));
  EXPECT_TRUE(question()->informativeText().contains("too coarse"));
  EXPECT_EQ(question()->escapeButton(), question()->defaultButton()) << "Enter and Escape both mean no";
  question()->reject();
  auto* page = window.findChild<TreatWorkspace*>();
  ASSERT_TRUE(fixtures::waitFor([&] { return !question(); }));
  EXPECT_FALSE(window.treat().isAligned());
  const auto buttons = page->findChildren<QPushButton*>();
  const auto align = std::find_if(buttons.begin(), buttons.end(),
                                  [](const auto* button) { return button->text().startsWith("2 Align"); });
  ASSERT_NE(align, buttons.end());
  (*align)->click();
  ASSERT_TRUE(fixtures::waitFor([&] { return question() != nullptr; }));
  for (auto* button : question()->buttons())
    if (question()->buttonRole(button) == QMessageBox::AcceptRole) {
      button->click();
      break;
    }
  EXPECT_TRUE(fixtures::waitFor([&] { return window.treat().isAligned(); }));
}

TEST(Treat, AClickSaysAtOnceWhatItDoes) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  std::promise<void> may_align;
  Services services = fakeServices();
  services.align = [plain = services.align, gate = std::shared_future<void>(may_align.get_future())](
                       const auto& store, const auto& recording, const auto& known, auto& task) {
    gate.wait_for(std::chrono::seconds(20));
    return plain(store, recording, known, task);
  };
  MainWindow window(services);
  window.show();
  window.openCase(QString::fromStdString(plannedCase(folder.path(), true).string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 240).string()), false);
  window.setWorkspace(Workspace::treat);
  const auto* figures = window.findChild<FiguresPanel*>();
  auto* page = window.findChild<TreatWorkspace*>();
  const auto says = [&](const QString& words) {
    const auto labels = page->findChildren<ElidedLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const auto* label) { return label->text().contains(words); });
  };
  EXPECT_TRUE(fixtures::waitFor([&] { return says("ALIGNING"); }));
  EXPECT_TRUE(window.tasks().isRunning());
  may_align.set_value();
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isAligned() && !window.tasks().isRunning(); }));
  EXPECT_TRUE(fixtures::waitFor([&] { return figures->instruction().contains("READY"); }));
  EXPECT_TRUE(fixtures::waitFor([&] { return !says("ALIGNING"); }));
  auto& treat = page->presenter();
  treat.start();
  EXPECT_TRUE(says("STARTING")) << "said before the trackers are ready";
  ASSERT_TRUE(fixtures::waitFor([&] { return treat.isRunning(); }));
  EXPECT_TRUE(treat.doingWords().isEmpty());
  treat.end();
}

TEST(Treat, GuidesWhileTheRecordingPlaysAndLeavesNoPoseStandingAtItsEnd) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const auto case_folder = plannedCase(folder.path(), true);
  MainWindow window(fakeServices());
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 240).string()), true);
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
  EXPECT_TRUE(fixtures::waitFor([&] { return scene_view->scene().showsCoil(); }));
  ASSERT_TRUE(fixtures::waitFor([&] { return figures->instruction().contains("ENDED"); }));
  EXPECT_EQ(figures->figures(), (std::array<QString, 4>{dash, dash, dash, dash}));
  EXPECT_TRUE(fixtures::waitFor([&] { return !scene_view->scene().showsCoil(); }));
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
  EXPECT_TRUE(fixtures::waitFor([&] { return header->text().endsWith("not aligned in this session"); }))
      << header->text().toStdString();
  EXPECT_TRUE(agree());
  window.play(QString::fromStdString(writeRecording(folder.path(), 50).string()), true);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isAligned() && window.isSettled(); }));
  EXPECT_TRUE(window.treat().alignmentWords().startsWith("aligned"));
  EXPECT_TRUE(fixtures::waitFor(agree)) << header->text().toStdString();
}

/// The button whose tooltip names the key.
QPushButton* buttonOf(MainWindow& window, const QString& key) {
  for (auto* button : window.findChildren<QPushButton*>())
    if (button->isVisible() && button->toolTip().contains("(" + key + ")")) return button;
  return nullptr;
}

TEST(Treat, EveryKeyThatATooltipNamesWorksAndSpaceStopsGuidanceNotTheSession) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const auto case_folder = plannedCase(folder.path(), true);
  MainWindow window(fakeServices());
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 600).string()), true);
  window.setWorkspace(Workspace::treat);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }));
  QApplication::setActiveWindow(&window);
  auto* cameras = buttonOf(window, "Ctrl+R");
  ASSERT_NE(cameras, nullptr);
  for (const bool is_shown : {true, false}) {
    QTest::keyClick(&window, Qt::Key_R, Qt::ControlModifier);
    EXPECT_TRUE(fixtures::waitFor([&] { return cameras->isChecked() == is_shown; })) << is_shown;
  }
  ASSERT_EQ(window.treat().pulses(), 0);
  QTest::keyClick(&window, Qt::Key_P);
  EXPECT_TRUE(fixtures::waitFor([&] { return window.treat().pulses() == 1; }));
  QTest::qWait(200);  // past the dead time of one source
  QTest::mouseClick(buttonOf(window, "P"), Qt::LeftButton);
  EXPECT_TRUE(fixtures::waitFor([&] { return window.treat().pulses() == 2; }));
  cameras->setFocus();  // a focused button must not swallow the stop key
  QTest::keyClick(cameras, Qt::Key_Space);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isPaused(); }));
  EXPECT_TRUE(window.treat().isRunning()) << "stopping guidance does not end the session";
  EXPECT_FALSE(cameras->isChecked());
  QTest::keyClick(&window, Qt::Key_Space);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isGuiding(); }));
  QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isEnding(); }));
  QTest::keyClick(&window, Qt::Key_Space);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isGuiding(); })) << "back to the session";
  QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
  window.findChild<QComboBox*>("end_pain")->setCurrentIndex(3);
  window.findChild<QLineEdit*>("end_adverse")->setText("headache");
  QTest::keyClick(window.findChild<QLineEdit*>("end_adverse"), Qt::Key_Return);
  ASSERT_FALSE(window.treat().isRunning());
  ASSERT_TRUE(fixtures::waitFor([&] { return window.workspace() == Workspace::review; }));
  auto* report = window.findChild<QTextBrowser*>("report_text");
  EXPECT_TRUE(fixtures::waitFor([&] {
    return report->isVisible() && report->toPlainText().contains("headache");
  })) << "the report opens: "
      << report->toPlainText().toStdString();
  EXPECT_TRUE(fixtures::waitFor([&] { return report->toPlainText().contains("ended normally"); }));
  window.setWorkspace(Workspace::treat);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().canAlign() && !window.tasks().isRunning(); }));
  bool has_aligned = false;
  QObject::connect(&window.tasks(), &TaskRunner::started, [&] { has_aligned = true; });
  QTest::keyClick(&window, Qt::Key_L, Qt::ControlModifier);
  EXPECT_TRUE(fixtures::waitFor([&] { return has_aligned && !window.tasks().isRunning(); }));
  QTest::keyClick(&window, Qt::Key_Space);
  EXPECT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }));
}

TEST(Treat, APauseIsABannerOverTheWholeWidthAndNothingSaysOnTarget) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const auto case_folder = plannedCase(folder.path(), true);
  MainWindow window(fakeServices());
  window.resize(1366, 768);
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 3000).string()), true);
  window.setWorkspace(Workspace::treat);
  auto* figures = window.findChild<FiguresPanel*>();
  ASSERT_TRUE(fixtures::waitFor([&] { return figures->instruction().contains("ON TARGET"); }));
  auto& treat = window.findChild<TreatWorkspace*>()->presenter();
  treat.pause("coil too warm");
  auto* banner = window.findChild<QFrame*>("pause_banner");
  ASSERT_TRUE(fixtures::waitFor([&] { return figures->instruction().contains("PAUSED"); }));
  EXPECT_TRUE(fixtures::waitFor([&] { return banner->isVisible(); }));
  EXPECT_GT(banner->width(), 0.9 * window.findChild<TreatWorkspace*>()->width());
  const QString words = banner->findChild<QLabel*>("pause_words")->text();
  EXPECT_TRUE(words.contains("PAUSED: coil too warm")) << words.toStdString();
  const QString time = treat.sessionTime();
  QApplication::setActiveWindow(&window);
  QTest::keyClick(&window, Qt::Key_P);
  ASSERT_TRUE(fixtures::waitFor([&] { return treat.pulses() == 1; })) << "a pulse in a pause is kept";
  for (int i = 0; i < 20; ++i) {
    QTest::qWait(60);
    EXPECT_FALSE(figures->instruction().contains("ON TARGET"));
  }
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
    window.grab().save(QString("%1/paused_1366.png").arg(pictures));
  EXPECT_EQ(treat.sessionTime(), time) << "the clock holds";
  EXPECT_EQ(treat.pulseCounts().on_target, 0);
  for (auto* label : window.findChildren<QLabel*>())
    EXPECT_FALSE(label->isVisible() && label->text().contains("on target", Qt::CaseInsensitive) &&
                 !label->text().contains("0 on target"))
        << label->text().toStdString();
  treat.resume();
  EXPECT_TRUE(fixtures::waitFor([&] { return figures->instruction().contains("ON TARGET"); }));
  EXPECT_TRUE(fixtures::waitFor([&] { return !banner->isVisible(); }));
}

TEST(Treat, ClosingTheWindowWhileASessionRunsAsks) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const auto case_folder = plannedCase(folder.path(), true);
  MainWindow window(fakeServices());
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 3000).string()), true);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isGuiding(); }));
  EXPECT_FALSE(window.close());
  EXPECT_TRUE(window.treat().isGuiding()) << "guidance goes on while the question stands";
  const auto question = [&]() -> QMessageBox* {
    for (auto* each : window.findChildren<QMessageBox*>("close_question"))
      if (each->isVisible()) return each;
    return nullptr;
  };
  const auto press = [&](const char* words) {
    ASSERT_NE(question(), nullptr);
    for (auto* button : question()->buttons())
      if (button->text().contains(words)) return button->click();
    FAIL() << words;
  };
  press("Keep");
  EXPECT_TRUE(fixtures::waitFor([&] { return !question(); }));
  EXPECT_TRUE(window.isVisible() && window.treat().isGuiding());
  window.close();
  press("End the session");
  EXPECT_TRUE(window.treat().isEnding());
  EXPECT_TRUE(fixtures::waitFor([&] { return !question(); }));
  window.close();
  press("Close at once");
  EXPECT_FALSE(window.isVisible());
  EXPECT_FALSE(window.treat().isRunning());
}

TEST(Treat, ARecordingIsAlignedAndGuidesOnlyWhenAsked) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const auto case_folder = plannedCase(folder.path(), true);
  MainWindow window(fakeServices());
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 300).string()));
  window.setWorkspace(Workspace::treat);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isAligned() && window.isSettled(); }));
  QTest::qWait(300);
  EXPECT_FALSE(window.treat().hasSession());
  EXPECT_TRUE(casefile::sessionFolders(case_folder).empty());
}

}  // namespace
}  // namespace facenav::ui
