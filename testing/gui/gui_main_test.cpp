// main() of the tests: makes a QApplication; without a display it uses the offscreen platform.

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>

#include "facenav/scene/display.h"
#include "shell/appearance.h"
#include "support/test_data.h"

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const facenav::testing::TemporaryFolder
      own;  // keeps the user's files and those of parallel tests untouched
  for (const char* place : {"XDG_DATA_HOME", "XDG_CONFIG_HOME"})
    qputenv(place, QByteArray::fromStdString(own.path().string()));
  if (!facenav::scene::hasDisplay())
    qputenv("QT_QPA_PLATFORM", "offscreen");  // presenters only; drawing tests skip
  facenav::ui::prepareSurfaceFormat();
  QApplication application(argc, argv);
  QApplication::setOrganizationName("FaceNav");
  QApplication::setApplicationName("FaceNav tests");
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, QString::fromStdString(own.path().string()));
  facenav::ui::applyAppearance(application);
  return RUN_ALL_TESTS();
}
