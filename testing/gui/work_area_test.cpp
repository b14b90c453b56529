// Windows start inside the work area with their frame, whatever the screen and the size of text.

#include "shell/work_area.h"

#include <gtest/gtest.h>

#include <QFrame>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>

#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "shell/appearance.h"
#include "shell/main_window.h"

namespace facenav::ui {
namespace {

const QMargins kFrame(1, 37, 1, 1);  // title bar and borders of a usual desktop

TEST(WorkArea, AWindowAndItsFrameStayInsideItOnSmallScreens) {
  for (const QSize& screen : {QSize(1366, 768), QSize(1280, 720)}) {
    const QRect area(QPoint(0, 27), screen - QSize(0, 27));  // a bar at the top
    const QRect content = fittedInto(area, {1480, 920}, kFrame);
    EXPECT_TRUE(area.contains(content.marginsAdded(kFrame)));
    EXPECT_EQ(content.size(), screen - QSize(2, 27 + 38));
  }
}

TEST(WorkArea, AWindowThatFitsHasTheWantedSizeInTheMiddle) {
  const QRect content = fittedInto({0, 0, 1920, 1080}, {1480, 920}, QMargins());
  EXPECT_EQ(content, QRect(220, 80, 1480, 920));
}

TEST(WorkArea, TheWindowStartsInsideTheScreenAtEverySizeOfText) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  for (const double text_scale : {1.0, 2.0}) {
    applyAppearance(*qApp, text_scale);
    MainWindow window{Services{}};
    window.show();
    fixtures::waitFor([] { return false; }, 400);
    EXPECT_TRUE(QApplication::primaryScreen()->availableGeometry().contains(window.frameGeometry()))
        << text_scale;
    applyAppearance(*qApp);
  }
}

/// Expects status line and header whole at this size, and that every page can be reached: if need be by
/// scrolling.
void expectInSight(MainWindow& window, const QSize& size) {
  window.resize(size);
  fixtures::waitFor([] { return false; }, 100);
  EXPECT_EQ(window.size(), size);
  for (const char* name : {"taskbar", "header"}) {
    const auto* part = window.findChild<QFrame*>(name);
    EXPECT_TRUE(window.rect().contains(QRect(part->mapTo(&window, QPoint()), part->size()))) << name;
  }
  const auto* area = window.findChild<QScrollArea*>("page_area");
  const QSize content = area->widget()->size(), room = area->viewport()->size();
  EXPECT_EQ(area->verticalScrollBar()->maximum(), std::max(0, content.height() - room.height()));
  EXPECT_EQ(area->horizontalScrollBar()->maximum(), std::max(0, content.width() - room.width()));
}

TEST(WorkArea, StatusLineAndEveryPageAreInSightOnSmallScreensAtDoubledText) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  applyAppearance(*qApp, 2.0);
  {
    MainWindow window{Services{}};
    window.show();
    for (int page = 0; page < 4; ++page) {
      window.setWorkspace(Workspace(page));
      expectInSight(window, {1366, 703});
      expectInSight(window, {1280, 655});
    }
  }
  applyAppearance(*qApp);
}

TEST(WorkArea, NothingScrollsAtUsualTextInsideTheFrameOf1280By720) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window{Services{}};
  window.show();
  for (int page = 0; page < 4; ++page) {
    window.setWorkspace(Workspace(page));
    expectInSight(window, {1278, 655});
    const auto* area = window.findChild<QScrollArea*>("page_area");
    EXPECT_EQ(area->verticalScrollBar()->maximum(), 0) << page;
    EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0) << page;
  }
}

}  // namespace
}  // namespace facenav::ui
