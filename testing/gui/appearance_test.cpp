// Checks the window's appearance: the size of text to be read from two metres, and that every button has
// text, a tooltip and a way to press it by keyboard. Colours: theme_test.cpp.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>

#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "prepare/prepare_workspace.h"
#include "shell/main_window.h"
#include "treat/figures_panel.h"
#include "treat/treat_workspace.h"

namespace facenav::ui {
namespace {

double pointSize(const QWidget& widget) {
  const QFont font = widget.font();
  return font.pointSizeF() > 0 ? font.pointSizeF() : font.pixelSize() * 72.0 / 96.0;
}

TEST(Appearance, TreatIsReadFromTwoMetres) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window{Services{}};
  window.show();
  window.setWorkspace(Workspace::treat);
  QApplication::processEvents();
  auto* treat = window.findChild<TreatWorkspace*>();
  int figures = 0;
  for (const auto* label : treat->findChildren<QLabel*>()) {
    label->ensurePolished();
    const bool is_figure = label->objectName().startsWith("figure");
    figures += is_figure;
    EXPECT_GE(pointSize(*label), is_figure ? 48.0 : 14.0) << label->text().toStdString();
  }
  EXPECT_EQ(figures, 6);  // figures of the coil on the target, and of its tip on the skin
  for (const auto* button : treat->findChildren<QAbstractButton*>()) {
    button->ensurePolished();
    EXPECT_GE(pointSize(*button), 14.0) << button->text().toStdString();
  }
}

TEST(Appearance, AFigureIsWholeTheMomentItComes) {
  FiguresPanel panel;
  panel.setStyleSheet("#figure_main { font-size: 64pt; } #figure { font-size: 48pt; }");
  panel.resize(520, 500);
  panel.show();
  QApplication::processEvents();
  session::NavigationState state;
  state.guidance.state = guidance::State::adjust;
  const Eigen::Vector2d none = Eigen::Vector2d::Zero();
  state.guidance.values = guidance::GuidanceValues{305.6, 99.9, -288.8, 0, 0, 0, none, none, none};
  ReadOut read_out = makeReadOut(state);
  EXPECT_EQ(read_out.depth, "-289");
  EXPECT_EQ(read_out.across, "99.9");
  read_out.tilt = "178\u00b0", read_out.twist = "-178\u00b0";
  panel.set(read_out);  // no layout runs in between
  int figures = 0;
  for (const auto* label : panel.findChildren<QLabel*>()) {
    if (!label->objectName().startsWith("figure")) continue;
    ++figures;
    EXPECT_GE(label->width(), label->fontMetrics().horizontalAdvance(label->text()))
        << label->text().toStdString();
  }
  EXPECT_EQ(figures, 4);
}

TEST(Appearance, EveryButtonHasATooltipAndTheKeyboardReachesIt) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window{Services{}};
  for (const auto* button : window.findChildren<QAbstractButton*>()) {
    if (button->objectName().startsWith("qt_") || button->text().isEmpty())
      continue;  // parts of Qt's own widgets
    EXPECT_FALSE(button->toolTip().isEmpty()) << button->text().toStdString();
    const bool is_reached = !button->shortcut().isEmpty() || button->focusPolicy() & Qt::TabFocus;
    EXPECT_TRUE(is_reached) << button->text().toStdString();
    if (!button->shortcut().isEmpty() && !button->text().contains(QChar(38))) {
      EXPECT_TRUE(button->toolTip().contains('(')) << "its key is not said: " << button->text().toStdString();
    }
  }
}

}  // namespace
}  // namespace facenav::ui
