// Every page in a window of 1280 x 720, and at twice the text size in one of 2560 x 1440: every control can
// be reached. FACENAV_GUI_PICTURES=DIR stores an image of each page, with the first case in
// FACENAV_GUI_CASES=DIR if that is given.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <cstdlib>

#include "every_page.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "shell/appearance.h"
#include "shell/main_window.h"
#include "shell/scene_view.h"
#include "shell/scroll_column.h"

namespace facenav::ui {
namespace {

ScrollColumn* scrollAround(const QWidget& widget) {
  for (auto* parent = widget.parentWidget(); parent; parent = parent->parentWidget())
    if (auto* column = dynamic_cast<ScrollColumn*>(parent)) return column;
  return nullptr;
}

bool isWhole(const QWidget& widget) { return widget.visibleRegion().boundingRect() == widget.rect(); }

/// Controls that a person presses, types into or reads a state from.
std::vector<QWidget*> controlsOf(MainWindow& window) {
  std::vector<QWidget*> controls;
  for (auto* widget : window.findChildren<QWidget*>()) {
    const bool is_control = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QLineEdit*>(widget) ||
                            qobject_cast<QComboBox*>(widget) || qobject_cast<QSlider*>(widget) ||
                            qobject_cast<QSpinBox*>(widget);
    const QString name = widget->objectName();
    const bool is_read =
        name == "banner" || name == "verdict" || name == "session" || name.startsWith("figure");
    const bool is_qts_own = name.startsWith("qt_") || qobject_cast<QAbstractSpinBox*>(widget->parentWidget());
    if (widget->isVisible() && !is_qts_own && (is_control || is_read)) controls.push_back(widget);
  }
  return controls;
}

std::string nameOf(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const QString words = button ? button->text() : widget.objectName() + " " + widget.toolTip().left(40);
  return std::string(widget.metaObject()->className()) + " '" + words.toStdString() + "'";
}

/// Expects each control fully inside the window, if needed after scrolling, and no button's text cut.
void expectInReach(MainWindow& window) {
  for (auto* widget : controlsOf(window)) {
    if (auto* column = scrollAround(*widget)) {
      EXPECT_TRUE(isWhole(*column)) << "the column of " << nameOf(*widget);
      const QPoint middle = widget->mapTo(column->widget(), widget->rect().center());
      column->ensureVisible(middle.x(), middle.y(), 0, widget->height() / 2 + 2);
      QApplication::processEvents();
    }
    EXPECT_TRUE(isWhole(*widget)) << nameOf(*widget);
    if (qobject_cast<QPushButton*>(widget)) {
      EXPECT_GE(widget->width(), widget->minimumSizeHint().width()) << nameOf(*widget);
    }
  }
}

/// Expects these visible without scrolling: the step bars, the sign-off button, the typed coordinates, handle
/// and gap of a target.
void expectAlwaysThere(MainWindow& window) {
  const std::vector<const char*> names{"1  Worklist", "4  Sign off", "1 Cameras", "2 Align", "3 Guide"};
  for (auto* button : window.findChildren<QAbstractButton*>()) {
    const bool is_step = std::any_of(names.begin(), names.end(),
                                     [&](const char* name) { return button->text().startsWith(name); });
    const bool is_sign_off = button->text() == "Sign off" || button->text() == "Looks right: sign off";
    if (button->isVisible() && (is_step || is_sign_off)) {
      EXPECT_FALSE(scrollAround(*button)) << nameOf(*button);
    }
  }
  for (auto* field : window.findChildren<QLineEdit*>()) {
    const QString name = field->accessibleName();
    const bool is_of_coil = name.startsWith("handle,") || name.startsWith("gap,");
    if (field->isVisible() && (is_of_coil || field->placeholderText().startsWith("x y z"))) {
      EXPECT_FALSE(scrollAround(*field)) << nameOf(*field);
    }
  }
}

std::filesystem::path someCase(const std::filesystem::path& folder) {
  if (const char* cases = std::getenv("FACENAV_GUI_CASES")) return casefile::listCases(cases).front().folder;
  return fixtures::writeFullCase(folder);
}

/// Lists the visible widgets that request over 300 px, with their request.
std::string widestParts(const QWidget& window) {
  std::string out;
  for (const auto* widget : window.findChildren<QWidget*>())
    if (const int least = std::max(widget->minimumSizeHint().width(), widget->minimumWidth());
        widget->isVisible() && least > 300)
      out += std::string(widget->metaObject()->className()) + " " + widget->objectName().toStdString() + " " +
             std::to_string(least) + "\n";
  return out;
}

/// Checks every page; restores the normal text size.
void expectEveryPageFits(const QSize& size, double text_scale, const QString& prefix) {
  applyAppearance(*qApp, text_scale);
  testing::TemporaryFolder folder;
  {
    MainWindow window{Services{}};
    window.show();
    window.setCasesFolder(QString::fromStdString(folder.path().string()));
    window.openCase(QString::fromStdString(someCase(folder.path()).string()));
    ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }, 60000));
    for (const auto& page : fixtures::everyPage()) {
      SCOPED_TRACE(prefix.toStdString() + page.name);
      page.show(window);
      window.resize(size);
      fixtures::waitFor([] { return false; }, 400);  // time for layout and drawing
      EXPECT_EQ(window.size(), size);
      EXPECT_LE(window.minimumSizeHint().width(), size.width()) << widestParts(window);
      EXPECT_LE(window.minimumSizeHint().height(), size.height());
      const auto* area = window.findChild<QScrollArea*>("page_area");  // scrolls only on smaller screens
      EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0) << widestParts(window);
      EXPECT_EQ(area->verticalScrollBar()->maximum(), 0);
      expectAlwaysThere(window);
      if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
        window.grab().save(QString("%1/%2%3.png").arg(pictures, prefix, page.name));
      expectInReach(window);
    }
  }
  applyAppearance(*qApp);
}

TEST(SmallWindow, EveryPageFitsInto1280By720) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  expectEveryPageFits({1280, 720}, 1.0, "small_");
}

TEST(SmallWindow, EveryPageFitsInto2560By1440AtTwiceTheTextSize) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  expectEveryPageFits({2560, 1440}, 2.0, "doubled_");
}

TEST(SmallWindow, AllTextFollowsTheOneSetting) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto sizesAt = [](double scale) {
    applyAppearance(*qApp, scale);
    MainWindow window{Services{}};
    std::vector<double> sizes;
    for (auto* widget : window.findChildren<QWidget*>()) {
      if (!qobject_cast<QLabel*>(widget) && !qobject_cast<QAbstractButton*>(widget)) continue;
      widget->ensurePolished();
      sizes.push_back(widget->font().pointSizeF());
    }
    applyAppearance(*qApp);
    return sizes;
  };
  const auto usual = sizesAt(1.0), twice = sizesAt(2.0);
  ASSERT_EQ(usual.size(), twice.size());
  ASSERT_GT(usual.size(), 50u);
  for (std::size_t i = 0; i < usual.size(); ++i) EXPECT_NEAR(twice[i], 2.0 * usual[i], 0.01) << i;
}

TEST(SmallWindow, TheScenesTextFollowsTheSameSetting) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto whitePixelsAt = [](double scale) {
    applyAppearance(*qApp, scale);
    SceneView view;
    view.scene().setBanner("COIL LOST");
    const RgbImage picture = view.scene().render(1200, 800);
    int n = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) n += picture.rgb[i] > 200;
    applyAppearance(*qApp);
    return n;
  };
  const int usual = whitePixelsAt(1.0);
  ASSERT_GT(usual, 300);
  EXPECT_NEAR(whitePixelsAt(2.0), 4.0 * usual, usual);
}

}  // namespace
}  // namespace facenav::ui
