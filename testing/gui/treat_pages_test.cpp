// The four tools of Treat (aim, motor, session, check) during guidance, in the usual window sizes: everything
// can be reached, no figure lies below the fold, and a pulse outside the tolerance is reported.
// FACENAV_GUI_PICTURES=DIR keeps an image of each.

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest/QTest>
#include <cstdlib>

#include "facenav/scene/display.h"
#include "shell/elided_label.h"
#include "shell/main_window.h"
#include "shell/scroll_column.h"
#include "treat/figures_panel.h"
#include "treat/motor_panel.h"
#include "treat/session_panel.h"
#include "treat/tip_panel.h"
#include "treat/treat_workspace.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;
using Tool = TreatWorkspace::Tool;

/// Expects the panel whole in its column after scrolling to it.
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
    window.play(QString::fromStdString(writeRecording(folder_.path(), 3000).string()), true);
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
  auto *pulses = treat->findChild<QLabel*>("session"), *counts = treat->findChild<QLabel*>("pulse_counts");
  EXPECT_TRUE(fixtures::waitFor([&] { return pulses->text() == "pulses 2"; }))
      << pulses->text().toStdString();
  EXPECT_TRUE(fixtures::waitFor([&] { return counts->text() == "1 on target, 1 outside"; }))
      << counts->text().toStdString();
  for (const QSize size : {QSize(1280, 720), QSize(1366, 768), QSize(1480, 860), QSize(1920, 1080)}) {
    window.resize(size);
    for (const auto& [tool, name] : {std::pair(Tool::aim, "aim"), std::pair(Tool::motor, "motor"),
                                     std::pair(Tool::session, "session"), std::pair(Tool::check, "check")}) {
      treat->showTool(tool);
      QTest::qWait(100);  // three refreshes of the page
      EXPECT_EQ(window.size(), size);
      for (const auto& [label, longest] :
           {std::pair(pulses, "pulses 2990/3000"), std::pair(counts, "2970 on target, 10 outside, 10 lost")})
        EXPECT_LE(label->fontMetrics().horizontalAdvance(longest), label->width()) << longest << name;
      EXPECT_TRUE(verdict->text().contains("OUTSIDE: ")) << verdict->text().toStdString();
      EXPECT_TRUE(fixtures::waitFor([&] {
        return verdict->heightForWidth(verdict->width()) <= verdict->height();
      })) << "told whole";
      if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
        window.grab().save(QString("%1/treat_%2_%3.png").arg(pictures).arg(size.width()).arg(name));
      if (tool == Tool::motor) expectInReach(*treat->findChild<MotorPanel*>());
      if (tool == Tool::session) expectInReach(*treat->findChild<SessionPanel*>());
      if (tool == Tool::check) expectInReach(*treat->findChild<TipPanel*>());
      if (tool != Tool::aim || size.height() < 860) continue;
      for (auto* label : treat->findChild<FiguresPanel*>()->findChildren<QLabel*>())
        EXPECT_TRUE(fixtures::waitFor([&] { return label->visibleRegion().boundingRect() == label->rect(); }))
            << "below the fold at " << size.width() << ": " << label->text().toStdString();
    }
  }
}

TEST(FiguresPanel, LongWordsGetSmallerLettersAndMoveNothing) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  QWidget treat;
  treat.setObjectName("treat");  // the name that the style sheet uses
  FiguresPanel panel(&treat);
  panel.resize(420, 460);
  treat.show();
  ReadOut read_out;
  read_out.level = Level::lost;
  read_out.instruction = "FACE LOST: turn to the cameras";
  panel.set(read_out);
  QTest::qWait(50);
  auto* banner = panel.findChild<QLabel*>("banner");
  auto* figure = panel.findChild<QLabel*>("figure");
  const QRect usual = figure->geometry();
  const int height = banner->height();
  read_out.instruction =
      "REGISTRATION FAILED: the face is 14.2 mm and 11.5 deg off, align again; the whole face must be seen";
  panel.set(read_out);
  QTest::qWait(50);
  EXPECT_EQ(banner->height(), height);
  EXPECT_EQ(figure->geometry(), usual);
  EXPECT_FALSE(banner->text().contains("font-size:30pt"))
      << "smaller letters: " << banner->text().toStdString();
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
  EXPECT_TRUE(fixtures::waitFor([&] { return treat->motor().state()->pulses == 1; }));
  EXPECT_EQ(treat->motor().state()->responses, 1);
  QTest::keyClick(&window, Qt::Key_N);
  QTest::qWait(100);
  EXPECT_EQ(treat->motor().state()->pulses, 1) << "one answer a pulse";
  QTest::keyClick(&window, Qt::Key_P);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().pulses() == 2; }));
  QTest::qWait(100);
  QTest::keyClick(&window, Qt::Key_N);
  EXPECT_TRUE(fixtures::waitFor([&] { return treat->motor().state()->pulses == 2; }));
  EXPECT_EQ(treat->motor().state()->responses, 1);
}

}  // namespace
}  // namespace facenav::ui
