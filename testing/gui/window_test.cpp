#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <QAbstractButton>
#include <QMouseEvent>
#include <QSettings>
#include <QtTest/QTest>
#include <set>
#include <vector>

#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "prepare/prepare_workspace.h"
#include "shell/main_window.h"
#include "shell/scene_view.h"
#include "shell/slice_view.h"
#include "treat/cameras_panel.h"

#define FACENAV_NEEDS_DISPLAY() \
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run"

namespace facenav::ui {
namespace {

int distinctColours(const QImage& image) {
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); y += 3)
    for (int x = 0; x < image.width(); x += 3) colours.insert(image.pixel(x, y) & 0xfffcfcfc);
  return int(colours.size());
}

/// Share of pixels whose red exceeds blue as on skin.
double warmShare(const QImage& image) {
  int warm = 0, all = 0;
  for (int y = 0; y < image.height(); y += 2)
    for (int x = 0; x < image.width(); x += 2, ++all)
      warm += qRed(image.pixel(x, y)) - qBlue(image.pixel(x, y)) > 6;
  return double(warm) / all;
}

template <class View>
QImage pictureOf(MainWindow& window) {
  for (View* view : window.findChildren<View*>())
    if (view->isVisible()) {
      const QPoint at = view->mapTo(&window, QPoint(0, 0));
      return window.grab(QRect(at, view->size())).toImage();
    }
  return {};
}

void showBallCase(MainWindow& window, const std::filesystem::path& folder) {
  window.show();
  window.openCase(QString::fromStdString(fixtures::writeBallCase(folder).string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }));
}

TEST(MainWindow, ShowsACaseInEveryWorkspace) {
  FACENAV_NEEDS_DISPLAY();
  testing::TemporaryFolder folder;
  MainWindow window{Services{}};
  showBallCase(window, folder.path());
  for (auto workspace : {Workspace::prepare, Workspace::plan}) {
    window.setWorkspace(workspace);
    QApplication::processEvents();
    const QImage scene = pictureOf<SceneView>(window);
    ASSERT_FALSE(scene.isNull());
    EXPECT_GT(distinctColours(scene), 30) << int(workspace);
    EXPECT_GT(warmShare(scene), 0.05) << int(workspace);  // the skin of the head
  }
  window.setWorkspace(Workspace::treat);  // opens on its first step: no cameras yet
  QApplication::processEvents();
  EXPECT_TRUE(window.findChild<CamerasPanel*>()->isVisible());
  window.setWorkspace(Workspace::prepare);
  QApplication::processEvents();
  const QImage slice = pictureOf<SliceView>(window);
  ASSERT_FALSE(slice.isNull());
  EXPECT_GT(qGreen(slice.pixel(slice.width() / 2 + 15, slice.height() / 2 + 15)), 120);  // tissue
  EXPECT_LT(qGreen(slice.pixel(4, slice.height() - 4)), 40);                             // air
}

void drag(QWidget* widget, Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPoint& by) {
  const QPoint from(widget->width() / 2, widget->height() / 2);
  QTest::mousePress(widget, button, keys, from);
  QMouseEvent move(QEvent::MouseMove, from + by, Qt::NoButton, button, keys);
  QApplication::sendEvent(widget, &move);
  QTest::mouseRelease(widget, button, keys, from + by);
}

TEST(SliceViews, SayTheirNumberPlaceAndValueAndComeBackToHowTheyWere) {
  FACENAV_NEEDS_DISPLAY();
  testing::TemporaryFolder folder;
  MainWindow window{Services{}};
  showBallCase(window, folder.path());
  QApplication::setActiveWindow(&window);
  SliceView* axial = nullptr;
  for (auto* view : window.findChildren<SliceView*>())
    if (!axial && view->isVisible()) axial = view;
  ASSERT_NE(axial, nullptr);
  EXPECT_EQ(axial->caption(), (QStringList{"axial  26/50", "S 0.0 mm", "value 160"}));
  QWheelEvent up({50, 50}, {50, 50}, {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
  for (int i = 0; i < 6; ++i) QApplication::sendEvent(axial, &up);
  EXPECT_EQ(axial->caption(), (QStringList{"axial  24/50", "I 6.0 mm", "value 160"}));
  axial->setFocus();  // its frame is part of the picture
  QApplication::processEvents();
  const QImage before = axial->grab().toImage();
  const auto upset = [&] {
    drag(axial, Qt::RightButton, {}, {0, -40});                  // zoom
    drag(axial, Qt::MiddleButton, {}, {30, 10});                 // pan
    drag(axial, Qt::LeftButton, Qt::ControlModifier, {60, 40});  // window and level
    EXPECT_NE(axial->grab().toImage(), before);
  };
  upset();
  QTest::keyClick(&window, Qt::Key_R);
  EXPECT_EQ(axial->grab().toImage(), before);
  upset();
  auto* button = axial->findChild<QAbstractButton*>();
  ASSERT_NE(button, nullptr);
  EXPECT_TRUE(button->toolTip().contains("(R)"));
  button->click();
  EXPECT_EQ(axial->grab().toImage(), before);
}

TEST(MainWindow, AMissingCaseIsSaidInWordsAndTheWindowLives) {
  FACENAV_NEEDS_DISPLAY();
  MainWindow window{Services{}};
  window.show();
  QString words;
  QObject::connect(&window.tasks(), &TaskRunner::failed, [&](const QString& w) { words = w; });
  window.openCase("/nowhere/case");
  ASSERT_TRUE(fixtures::waitFor([&] { return !words.isEmpty(); }));
  EXPECT_TRUE(words.contains("/nowhere/case"));
  window.setWorkspace(Workspace::treat);
  QApplication::processEvents();
}

TEST(MainWindow, ComesBackWithCaseWorkspaceStepAndLookEvenAfterACrash) {
  FACENAV_NEEDS_DISPLAY();
  QSettings().clear();
  testing::TemporaryFolder folder;
  casefile::CaseStore::create(folder.path() / "case", fixtures::ballWithBrain(), {}, false);
  const auto settled = [](MainWindow& window) {
    return fixtures::waitFor([&] { return !window.tasks().isRunning() && !window.cortex().isMaking(); },
                             30000);
  };
  {
    MainWindow window{Services{}};
    window.show();
    window.openCase(QString::fromStdString((folder.path() / "case").string()));
    ASSERT_TRUE(settled(window));
    window.setPrepareStep(PrepareStep::sign_off);
    window.setWorkspace(Workspace::plan);
    for (auto* button : window.findChildren<QAbstractButton*>())
      if (button->text() == "Side by side") button->click();
    ASSERT_TRUE(settled(window));
    QApplication::processEvents();
  }  // destroyed without being closed
  MainWindow window{Services{}};
  window.show();
  window.restoreLast();
  ASSERT_TRUE(settled(window));
  EXPECT_EQ(window.workspace(), Workspace::plan);
  EXPECT_EQ(window.prepareStep(), PrepareStep::sign_off);
  EXPECT_TRUE(window.cortex().isBesideModel());
  EXPECT_FALSE(window.treat().isAligned());
  ASSERT_TRUE(fixtures::waitFor([&] { return window.cortex().cortex() != nullptr; }, 30000));
  QApplication::processEvents();
  std::vector<SceneView*> seen;
  for (auto* view : window.findChildren<SceneView*>())
    if (view->isVisible()) seen.push_back(view);
  ASSERT_EQ(seen.size(), 2u);  // model and distance, seen from one viewpoint
  EXPECT_EQ(seen[0]->scene().renderer()->GetActiveCamera(), seen[1]->scene().renderer()->GetActiveCamera());
  QSettings().clear();
}

TEST(MainWindow, OpensACaseAtTheStepAskedFor) {
  FACENAV_NEEDS_DISPLAY();
  QSettings().clear();
  testing::TemporaryFolder folder;
  const QString case_folder = QString::fromStdString(fixtures::writeBallCase(folder.path()).string());
  MainWindow window{Services{}};
  window.show();
  for (const auto step : {PrepareStep::sign_off, PrepareStep::worklist, PrepareStep::check}) {
    window.openCaseAt(case_folder, step);
    ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }));
    EXPECT_EQ(window.prepareStep(), step);
  }
  MainWindow again{Services{}};  // also if the case is the last session's
  again.show();
  again.restoreLast();
  again.setPrepareStep(PrepareStep::sign_off);
  ASSERT_TRUE(fixtures::waitFor([&] { return !again.tasks().isRunning(); }));
  EXPECT_EQ(again.prepareStep(), PrepareStep::sign_off);
  QSettings().clear();
}

TEST(MainWindow, EveryButtonSaysWhatItDoes) {
  FACENAV_NEEDS_DISPLAY();
  MainWindow window{Services{}};
  window.show();
  QApplication::processEvents();
  for (const auto* button : window.findChildren<QAbstractButton*>())
    if (button->isVisible()) {
      EXPECT_FALSE(button->text().isEmpty() && button->toolTip().isEmpty());
    }
}

}  // namespace
}  // namespace facenav::ui
