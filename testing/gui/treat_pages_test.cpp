// The three tools of Treat (aim, motor, session) during guidance, in the two usual window sizes: everything
// can be reached, and a pulse outside the tolerance is said. FACENAV_GUI_PICTURES=DIR keeps an image of each.

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest/QTest>
#include <cstdlib>

#include "facenav/scene/display.h"
#include "main_window.h"
#include "treat_fixtures.h"
#include "widgets/elided_label.h"
#include "widgets/motor_panel.h"
#include "widgets/scroll_column.h"
#include "widgets/session_panel.h"
#include "workspaces/treat_workspace.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;
using Tool = TreatWorkspace::Tool;

/// Whole in its column once that is scrolled to it.
void expectInReach(const QWidget& panel) {
  for (auto* widget : panel.findChildren<QWidget*>()) {
    if (!qobject_cast<QPushButton*>(widget) && !qobject_cast<QLineEdit*>(widget)) continue;
    if (!widget->isVisible()) continue;
    for (auto* parent = widget->parentWidget(); parent; parent = parent->parentWidget())
      if (auto* column = dynamic_cast<ScrollColumn*>(parent)) {
        const QPoint middle = widget->mapTo(column->widget(), widget->rect().center());
        column->ensureVisible(middle.x(), middle.y(), 0, widget->height() / 2 + 2);
        QApplication::processEvents();
      }
    EXPECT_EQ(widget->visibleRegion().boundingRect(), widget->rect())
        << widget->toolTip().toStdString() << ", " << panel.metaObject()->className();
  }
}

class TreatPages : public ::testing::Test {
 protected:
  void guide(MainWindow& window) {
    const auto case_folder = plannedCase(folder_.path(), true);
    window.show();
    window.openCase(QString::fromStdString(case_folder.string()));
    window.play(QString::fromStdString(writeRecording(folder_.path(), 3000).string()));
    window.setWorkspace(Workspace::treat);
    ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }));
    ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().state()->frame > 2; }));
  }
  testing::TemporaryFolder folder_;
};

TEST_F(TreatPages, EverythingIsInReachAndAPulseOutsideIsSaid) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window(fakeServices());
  guide(window);
  auto* treat = window.findChild<TreatWorkspace*>();
  treat->motor().search(stimulation::ThresholdMethod::bayes, "FDI right");
  treat->motor().hunt();
  QApplication::setActiveWindow(&window);
  QTest::keyClick(&window, Qt::Key_P);
  auto* verdict = treat->findChild<QLabel*>("last_pulse");
  ASSERT_NE(verdict, nullptr);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().pulseCounts().on_target == 1; }));
  treat->motor().nextSite();
  QTest::qWait(300);  // past the key's dead time, and with the new target in force
  QTest::keyClick(&window, Qt::Key_P);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().pulseCounts().outside == 1; }));
  EXPECT_TRUE(fixtures::waitFor([&] { return verdict->property("is_bad").toBool(); }));
  EXPECT_TRUE(treat->findChild<QLabel*>("session")->text().contains("1 outside"));
  for (const QSize size : {QSize(1366, 768), QSize(1920, 1080)}) {
    window.resize(size);
    for (const auto& [tool, name] : {std::pair(Tool::aim, "aim"), std::pair(Tool::motor, "motor"),
                                     std::pair(Tool::session, "session")}) {
      treat->showTool(tool);
      QTest::qWait(400);
      EXPECT_EQ(window.size(), size);
      if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
        window.grab().save(QString("%1/treat_%2_%3.png").arg(pictures).arg(size.width()).arg(name));
      if (tool == Tool::motor) expectInReach(*treat->findChild<MotorPanel*>());
      if (tool == Tool::session) expectInReach(*treat->findChild<SessionPanel*>());
    }
  }
}

TEST_F(TreatPages, TheKeysYAndNAnswerOnTheMotorPageOnly) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window(fakeServices());
  guide(window);
  auto* treat = window.findChild<TreatWorkspace*>();
  treat->motor().search(stimulation::ThresholdMethod::bayes, "");
  QApplication::setActiveWindow(&window);
  QTest::keyClick(&window, Qt::Key_P);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().pulses() == 1; }));
  QTest::keyClick(&window, Qt::Key_Y);
  QTest::qWait(50);
  EXPECT_EQ(treat->motor().state()->pulses, 0) << "the page is not shown";
  treat->showTool(Tool::motor);
  QTest::qWait(50);
  QTest::keyClick(&window, Qt::Key_Y);
  EXPECT_TRUE(fixtures::waitFor([&] { return treat->motor().state()->pulses == 1; }, 2000));
  EXPECT_EQ(treat->motor().state()->responses, 1);
  QTest::keyClick(&window, Qt::Key_N);
  EXPECT_TRUE(fixtures::waitFor([&] { return treat->motor().state()->pulses == 2; }, 2000));
  EXPECT_EQ(treat->motor().state()->responses, 1);
}

}  // namespace
}  // namespace facenav::ui
