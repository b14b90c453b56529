// The test program's own main: a QApplication, where there is a display.

#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>

#include "appearance.h"
#include "facenav/scene/display.h"
#include "support/test_data.h"

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  QStandardPaths::setTestModeEnabled(true);
  if (!facenav::scene::hasDisplay())
    qputenv("QT_QPA_PLATFORM", "offscreen");  // presenters only; drawing tests skip
  facenav::ui::prepareSurfaceFormat();
  QApplication application(argc, argv);
  QApplication::setOrganizationName("FaceNav");
  QApplication::setApplicationName("FaceNav tests");
  const facenav::testing::TemporaryFolder settings;  // a user's own are never read or written
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(settings.path().string()));
  facenav::ui::applyAppearance(application);
  return RUN_ALL_TESTS();
}
