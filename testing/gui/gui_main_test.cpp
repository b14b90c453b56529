// The test program's own main: a QApplication, where there is a display.

#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>

#include "appearance.h"
#include "facenav/scene/display.h"

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  if (!facenav::scene::hasDisplay())
    qputenv("QT_QPA_PLATFORM", "offscreen");  // presenters only; drawing tests skip
  facenav::ui::prepareSurfaceFormat();
  QApplication application(argc, argv);
  facenav::ui::applyAppearance(application);
  return RUN_ALL_TESTS();
}
