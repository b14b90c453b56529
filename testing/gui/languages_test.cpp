// The window's language: its choice, and the sentences of the modules in it.

#include <gtest/gtest.h>

#include <QAction>
#include <QBuffer>
#include <QSettings>
#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/scene/display.h"
#include "shell/core_sentences.h"
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

const char* const kCatalogue =
    R"(<?xml version="1.0" encoding="utf-8"?><!DOCTYPE TS><TS version="2.1" language="de">
<context><name>core</name>
<message><source>the head moved by %1 mm and %2 deg</source><translation>Kopf um %2 Grad und %1 mm bewegt</translation></message>
<message><source>hold the head still</source><translation>Kopf still halten</translation></message>
<message><source>not aligned</source><translation>nicht ausgerichtet</translation></message>
<message><source>no picture was taken: %1</source><translation>kein Bild: %1</translation></message>
<message><source>%1 is empty</source><translation>%1 ist leer</translation></message>
<message><source>not finished</source><translation type="unfinished">X</translation></message>
</context>
<context><name>other</name><message><source>two words</source><translation>X</translation></message></context></TS>)";

QString german(const QString& words) {
  QByteArray text(kCatalogue);
  QBuffer file(&text);
  file.open(QIODevice::ReadOnly);
  const CoreSentences sentences(file);
  EXPECT_EQ(sentences.count(), 5u);
  return sentences.translated(words);
}

TEST(CoreSentences, ValuesMoveToTheirPlacesInTheTranslation) {
  EXPECT_EQ(german("the head moved by 3.5 mm and 2 deg"), "Kopf um 2 Grad und 3.5 mm bewegt");
}

TEST(CoreSentences, EachSentenceOfATextIsTranslatedAndWhatJoinsThemStays) {
  EXPECT_EQ(german("not aligned: the head moved by 3.5 mm and 2 deg; hold the head still."),
            "nicht ausgerichtet: Kopf um 2 Grad und 3.5 mm bewegt; Kopf still halten.");
  EXPECT_EQ(german("/tmp/a.yml: hold the head still (not aligned)"),
            "/tmp/a.yml: Kopf still halten (nicht ausgerichtet)");
}

TEST(CoreSentences, ASentenceInAnotherIsTranslatedToo) {
  EXPECT_EQ(german("no picture was taken: hold the head still"), "kein Bild: Kopf still halten");
}

TEST(CoreSentences, WhatTheCatalogueLacksStaysAsItIs) {
  for (const char* words : {"", "a new sentence", "not finished", "two words", "hold the head still now",
                            "the head moved by 3.5 mm"})
    EXPECT_EQ(german(words), words);
  EXPECT_EQ(german("a new sentence; hold the head still"), "a new sentence; Kopf still halten");
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
