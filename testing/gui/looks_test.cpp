// Looks of every page: texts are whole at each text size, on a small screen and on a large one with four
// pixels for one; every control has a name for screen readers, is reached by Tab and shows its focus; buttons
// of Treat are large enough for a finger; each page looks as its kept picture in both themes.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAccessible>
#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTabBar>
#include <QtTest/QTest>
#include <set>

#include "every_page.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "home/home_window.h"
#include "setup/setup_window.h"
#include "shell/appearance.h"
#include "shell/help_window.h"
#include "shell/main_window.h"
#include "shell/theme.h"
#include "support/kept_pictures.h"
#include "support/run_program.h"
#include "support/window_checks.h"
#include "treat/treat_side.h"
#include "treat/treat_workspace.h"

namespace facenav::ui {
namespace {

constexpr QSize kSmall{1366, 768};
/// Least height of what a finger presses: WCAG 2.1, success criterion 2.5.5, 44 CSS pixels at 96 dpi.
constexpr int kFinger_px = 44;
constexpr int kSettle_ms = 30;

/// Pages with the least room to spare, for sizes between those that all pages are tried at.
const QStringList kFullest{"1_worklist", "5_plan", "6_treat_motor", "6_treat_session", "8_review_report"};

/// One window with a full case, made once for all tests.
class Looks : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!scene::hasDisplay()) return;
    QSettings().clear();
    folder_ = new testing::TemporaryFolder;
    window_ = new MainWindow{Services{}};
    window_->resize(kSmall);
    window_->show();
    window_->setCasesFolder(QString::fromStdString(folder_->path().string()));
    window_->openCase(QString::fromStdString(fixtures::writeFullCase(folder_->path()).string()));
    ASSERT_TRUE(fixtures::waitFor([] { return !window_->tasks().isRunning(); }, 60000));
  }
  static void TearDownTestSuite() {
    delete window_;
    delete folder_;
    window_ = nullptr, folder_ = nullptr;
    QSettings().clear();
  }
  void SetUp() override {
    if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    QApplication::setActiveWindow(window_);
  }
  /// Shows each page and tool, and looks at it.
  static void onEveryPage(const std::function<void(const char* page)>& look, const QStringList& only = {}) {
    for (const auto& page : fixtures::pagesAndTools()) {
      if (!only.isEmpty() && !only.contains(page.name)) continue;
      SCOPED_TRACE(page.name);
      page.show(*window_);
      fixtures::settle();
      look(page.name);
    }
  }
  static void expectWhole(double text_scale, const QSize& size, const QStringList& only = {}) {
    SCOPED_TRACE("text at " + std::to_string(int(100 * text_scale)) + " %");
    changeTextScale(*qApp, text_scale);
    window_->resize(size);
    onEveryPage(
        [&](const char*) {
          EXPECT_EQ(window_->size(), size);
          for (const QString& fault : testing::cutTexts(*window_) + testing::misplacedParts(*window_))
            ADD_FAILURE() << fault.toStdString();
        },
        only);
  }
  static MainWindow* window_;
  static testing::TemporaryFolder* folder_;
};
MainWindow* Looks::window_ = nullptr;
testing::TemporaryFolder* Looks::folder_ = nullptr;

/// Parts whose content differs from run to run.
const QStringList kChanging{"worklist",    "sessions",     "pulses",    "session",
                            "report_text", "session_time", "last_pulse"};

// The first test: the window is as at its start.
TEST_F(Looks, EveryPageLooksAsKeptInBothThemes) {
  const testing::KeptPictures kept(std::filesystem::path(FACENAV_SOURCE_DIR) / "testing/gui/pictures",
                                   testing::KeptPictures::useFromEnvironment());
  changeTextScale(*qApp, 1.0);
  window_->resize(kSmall);
  QCursor::setPos(QGuiApplication::primaryScreen()->geometry().bottomRight());
  QApplication::setCursorFlashTime(0);
  for (const auto choice : {ThemeChoice::light, ThemeChoice::dark}) {
    changeTheme(*qApp, choice);
    const QString theme = choice == ThemeChoice::light ? "light_" : "dark_";
    onEveryPage([&](const char* page) {
      if (QLatin1String(page) == "6_treat_figures") return;  // as 6_treat_aim
      const QString name = theme + page;
      if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
        window_->grab().save(QString("%1/%2.png").arg(pictures, name));
      QApplication::setActiveWindow(window_);
      if (auto* focused = QApplication::focusWidget()) focused->clearFocus();
      fixtures::settle();
      if (kept.use() != testing::KeptPictures::Use::compare) QTest::qWait(10 * kSettle_ms);
      QString fault;  // a view may draw a moment later
      for (int tries = 0; tries < 40; ++tries) {
        fault = kept.show(name, testing::smallColouredPicture(*window_, kChanging));
        if (fault.isEmpty()) break;
        QTest::qWait(4 * kSettle_ms);
      }
      EXPECT_TRUE(fault.isEmpty()) << fault.toStdString();
    });
  }
}

std::string wordsFor(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  return std::string(widget.metaObject()->className()) + " '" +
         (button ? button->text() : widget.objectName() + " " + widget.toolTip().left(40)).toStdString() +
         "' in " + widget.parentWidget()->metaObject()->className();
}

/// True for a part of one of Qt's own widgets, which that widget speaks for.
bool isQtsPart(const QWidget& widget) {
  return widget.objectName().startsWith("qt_") || qobject_cast<QComboBox*>(widget.parentWidget()) ||
         qobject_cast<QTabBar*>(widget.parentWidget()) ||
         widget.parentWidget()->inherits("QAbstractSpinBox") ||
         widget.parentWidget()->inherits("QLineEdit") || widget.inherits("QComboBoxListView") ||
         widget.inherits("QMenu") || widget.inherits("QMenuBar");
}

/// Returns how many controls of the window have a name. A hidden button gets its words when it is shown.
int expectNames(const QWidget& window) {
  int named = 0;
  for (auto* widget : window.findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || isQtsPart(*widget)) continue;
    if (qobject_cast<QAbstractButton*>(widget) && widget->isHidden()) continue;
    auto* face = QAccessible::queryAccessibleInterface(widget);
    const auto* label = qobject_cast<QLabel*>(widget);
    if (label && label->text().isEmpty()) continue;  // a label's name is its text
    const bool has_name = face && !face->text(QAccessible::Name).trimmed().isEmpty();
    EXPECT_TRUE(has_name) << wordsFor(*widget);
    named += has_name;
  }
  return named;
}

TEST_F(Looks, EveryControlHasANameForScreenReaders) {
  EXPECT_GT(expectNames(*window_), 100);
  expectNames(HomeWindow{Services{}});
  EXPECT_GT(expectNames(SetupWindow{Services{}}), 10);
  EXPECT_GE(expectNames(HelpWindow::of(*window_)), 4);
}

/// True for a button of a group: Tab reaches one of them, and the arrow keys reach the others.
bool isReachedByArrows(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  return button && button->group();
}

/// Visible controls that Tab should reach now.
std::set<QWidget*> reachable(const QWidget& window) {
  std::set<QWidget*> all;
  for (auto* widget : window.findChildren<QWidget*>())
    if (widget->isVisible() && widget->isEnabled() && widget->window() == &window &&
        (widget->focusPolicy() & Qt::TabFocus) == Qt::TabFocus && !widget->focusProxy() &&
        !isReachedByArrows(*widget) && !isQtsPart(*widget))
      all.insert(widget);
  return all;
}

/// True if the picture of the widget changes when it gets the focus.
bool showsFocus(QWidget& widget) {
  const QImage with = widget.grab().toImage();
  widget.clearFocus();
  const QImage without = widget.grab().toImage();
  widget.setFocus(Qt::TabFocusReason);
  return with != without;
}

TEST_F(Looks, TabReachesEveryControlAndTheFocusIsSeen) {
  std::set<QWidget*> judged;  // a control that several pages share is judged once
  onEveryPage([&](const char*) {
    std::set<QWidget*> missed = reachable(*window_);
    if (missed.empty()) return;
    if (auto* before = QApplication::focusWidget()) before->clearFocus();
    (*missed.begin())->setFocus(Qt::TabFocusReason);
    const int most = 3 * int(missed.size()) + 20;
    for (int i = 0; i < most && !missed.empty(); ++i) {
      QWidget* at = QApplication::focusWidget();
      ASSERT_TRUE(at);
      missed.erase(at);
      if (!isQtsPart(*at) && judged.insert(at).second) {
        EXPECT_TRUE(showsFocus(*at)) << "its focus is not seen: " << wordsFor(*at);
      }
      QTest::keyClick(at, Qt::Key_Tab);
    }
    for (const auto* widget : missed) ADD_FAILURE() << "Tab does not reach " << wordsFor(*widget);
  });
}

TEST_F(Looks, WhatAFingerPressesInTreatIsLargeEnough) {
  changeTextScale(*qApp, 1.0);
  window_->resize(kSmall);
  window_->setWorkspace(Workspace::treat);
  auto* treat = window_->findChild<TreatWorkspace*>();
  int buttons = 0;
  onEveryPage([&](const char*) {
    for (auto* button : treat->findChildren<QAbstractButton*>()) {
      if (!button->isVisible() || isQtsPart(*button)) continue;
      ++buttons;
      EXPECT_GE(button->height(), kFinger_px) << wordsFor(*button);
    }
    for (auto* tabs : treat->findChildren<QTabBar*>())
      for (int i = 0; i < tabs->count() && tabs->isVisible(); ++i)
        EXPECT_GE(tabs->tabRect(i).height(), kFinger_px) << tabs->tabText(i).toStdString();
    for (auto* box : treat->findChildren<QComboBox*>()) {
      EXPECT_TRUE(!box->isVisible() || box->height() >= kFinger_px) << wordsFor(*box);
    }
  });
  EXPECT_GT(buttons, 20);
}

TEST_F(Looks, EveryTextIsWholeAtEachTextSize) {
  for (const double text_scale : {1.25, 1.5}) expectWhole(text_scale, kSmall, kFullest);
  expectWhole(2.0, kSmall);
  changeTextScale(*qApp, 1.0);
}

/// Run by the next test in a process of its own, with two pixels for each unit of length.
TEST_F(Looks, DISABLED_EveryTextIsWholeHere) {
  EXPECT_EQ(window_->devicePixelRatioF(), 2.0);
  expectWhole(1.0, QSize(3840, 2160) / 2, kFullest);
}

TEST_F(Looks, EveryTextIsWholeOn3840By2160WithFourPixelsForOne) {
  qputenv("QT_SCALE_FACTOR", "2");
  const auto result = testing::runProgram(QCoreApplication::applicationFilePath().toStdString(),
                                          "--gtest_also_run_disabled_tests --gtest_brief=1 "
                                          "--gtest_filter=Looks.DISABLED_EveryTextIsWholeHere");
  qunsetenv("QT_SCALE_FACTOR");
  EXPECT_EQ(result.status, 0) << result.output << result.errors;
}

}  // namespace
}  // namespace facenav::ui
