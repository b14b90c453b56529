// Looks of Home and of the set-up of the cameras: each page looks as its kept picture in both themes.

#include <gtest/gtest.h>

#include <QSettings>
#include <QtTest/QTest>

#include "every_page.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "home_and_setup_pages.h"
#include "shell/appearance.h"
#include "shell/theme.h"
#include "support/kept_pictures.h"

namespace facenav::ui {
namespace {

constexpr QSize kLaptop{1366, 768};
constexpr int kDraws_ms = 120;  // longer than the refresh of these windows

class HomeAndSetUpLooks : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    QSettings().clear();
    changeTextScale(*qApp, 1.0);
  }
  void TearDown() override {
    changeTheme(*qApp, ThemeChoice::dark);
    QSettings().clear();
  }
  /// Compares the page with its pictures in both themes.
  void look(QWidget& window, const char* page) {
    for (const auto choice : {ThemeChoice::light, ThemeChoice::dark}) {
      changeTheme(*qApp, choice);
      QApplication::setActiveWindow(&window);
      if (auto* focused = QApplication::focusWidget()) focused->clearFocus();
      fixtures::settle();
      QTest::qWait(kDraws_ms);
      const QString name = (choice == ThemeChoice::light ? "light_" : "dark_") + QString(page);
      if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
        window.grab().save(QString("%1/%2.png").arg(pictures, name));
      QString fault;
      for (int tries = 0; tries < 20; ++tries) {
        fault = kept_.show(name, testing::smallColouredPicture(window, {"live"}));
        if (fault.isEmpty()) break;
        QTest::qWait(kDraws_ms);
      }
      EXPECT_TRUE(fault.isEmpty()) << fault.toStdString();
    }
  }
  const testing::KeptPictures kept_{std::filesystem::path(FACENAV_SOURCE_DIR) / "testing/gui/pictures",
                                    testing::KeptPictures::useFromEnvironment()};
};

TEST_F(HomeAndSetUpLooks, EveryPageOfHomeLooksAsKept) {
  fixtures::onEveryHomePage(kLaptop, [this](QWidget& window, const char* page) { look(window, page); });
}

TEST_F(HomeAndSetUpLooks, EveryPageOfTheSetUpLooksAsKept) {
  fixtures::onEverySetUpPage(kLaptop, [this](QWidget& window, const char* page) { look(window, page); });
}

}  // namespace
}  // namespace facenav::ui
