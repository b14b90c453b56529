// The window's language: its choice, and the sentences of the modules in it.

#include <gtest/gtest.h>

#include <QAction>
#include <QSettings>
#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/scene/display.h"
#include "shell/language.h"
#include "shell/main_window.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

class LanguagesTest : public ::testing::Test {
 protected:
  void SetUp() override { QSettings().clear(); }
  void TearDown() override {
    qunsetenv("FACENAV_LANGUAGE");
    applyLanguage(*qApp, "en");
    QSettings().clear();
  }
};

TEST_F(LanguagesTest, EnglishIsFirstAndJapaneseIsThere) {
  const auto all = languages();
  ASSERT_GE(all.size(), 2u);
  EXPECT_EQ(all[0].code, "en");
  const auto japanese =
      std::find_if(all.begin(), all.end(), [](const auto& one) { return one.code == "ja"; });
  ASSERT_NE(japanese, all.end());
  EXPECT_EQ(japanese->name, QString::fromUtf8("日本語"));
}

TEST_F(LanguagesTest, TheEnvironmentWinsOverWhatIsRemembered) {
  rememberLanguage("ja");
  EXPECT_EQ(wantedLanguage(), "ja");
  qputenv("FACENAV_LANGUAGE", "en_GB");
  EXPECT_EQ(wantedLanguage(), "en");
  qputenv("FACENAV_LANGUAGE", "xx");  // no such catalogue
  EXPECT_EQ(wantedLanguage(), "ja");
}

TEST_F(LanguagesTest, ALanguageIsAppliedAndTakenBack) {
  EXPECT_EQ(MainWindow::tr("&Quit"), "&Quit");
  applyLanguage(*qApp, "ja");
  EXPECT_EQ(languageInForce(), "ja");
  EXPECT_NE(MainWindow::tr("&Quit"), "&Quit");
  applyLanguage(*qApp, "xx");
  EXPECT_EQ(languageInForce(), "en");
  EXPECT_EQ(MainWindow::tr("&Quit"), "&Quit");
}

TEST_F(LanguagesTest, AChosenLanguageIsRememberedForTheNextStart) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window{Services{}};
  for (auto* action : window.findChildren<QAction*>())
    if (action->text() == QString::fromUtf8("日本語")) action->trigger();
  EXPECT_EQ(rememberedLanguage(), "ja");
  EXPECT_EQ(languageInForce(), "en");
}

TEST_F(LanguagesTest, ARefusalOfAModuleIsShownInTheWindowsLanguage) {
  const Error error("not aligned: this scan holds no face to align to", "case.json",
                    "use a scan of the whole head");
  EXPECT_EQ(shownWords(error), QString::fromStdString(error.what()));
  applyLanguage(*qApp, "ja");
  EXPECT_FALSE(shownWords(error).contains("face")) << shownWords(error).toStdString();
  EXPECT_TRUE(shownWords(error).startsWith("case.json: "));
}

}  // namespace
}  // namespace facenav::ui
