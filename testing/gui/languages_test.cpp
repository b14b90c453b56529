// The window in another language: its choice, the sentences of the modules in it, and every page of the
// window in Japanese without English words.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QBuffer>
#include <QComboBox>
#include <QFontDatabase>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QTabBar>
#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/guidance/target.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "prepare/prepare_workspace.h"
#include "review/review_workspace.h"
#include "shell/core_sentences.h"
#include "shell/language.h"
#include "shell/main_window.h"
#include "shell/screenshot.h"
#include "shell/shown_words.h"
#include "shell/users_words.h"
#include "support/made_session.h"

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

/// Words in Latin letters that a Japanese text may hold: names, units, files, keys, and what a person wrote.
bool isForeign(const QString& word) {
  static const QRegularExpression kName(
      "^(mm|cm|cm2|ml|deg|px|ms|min|Hz|kHz|MB|GB|V|m|A|us|uV|RAS|MRI|DICOM|PACS|TLS|T1|CSV|FaceNav|MEP|MEPs|"
      "EEG|EMG|"
      "Ctrl|Shift|Alt|Esc|Enter|Space|Tab|Del|Delete|Home|End|Page|Up|Down|F\\d+|[A-Z]|[xyzst]|\\d+x?|Beam|"
      "MNI|AAL|"
      "HMAC|UID|ID|IP|USB|LSL|OSC|UDP|TCP|igtl|lsl|osc|udp|tcp|serial|sound|invesalius|robot|json|yml|html|"
      "pdf|png|"
      "facenav|case|Hotspot)$");
  return !kName.match(word).hasMatch();
}

/// The English words of a text, without mnemonics, tags, files, addresses and names that hold a digit or a
/// dot.
QStringList englishWords(QString text) {
  text.remove(QRegularExpression("<[^>]*>|\\(&.\\)|&"));
  text.remove(QRegularExpression("\\S*[/\\\\@_.:\\d]\\S*"));
  QStringList words;
  static const QRegularExpression kWord("[A-Za-z]{2,}");
  for (auto it = kWord.globalMatch(text); it.hasNext();)
    if (const QString word = it.next().captured(); isForeign(word)) words << word;
  return words;
}

void addIfEnglish(QStringList& found, const QWidget& widget, const QString& text) {
  if (holdsUsersWords(widget) || englishWords(text).isEmpty()) return;
  const QString line = QString(widget.metaObject()->className()) + " '" + text + "'";
  if (!found.contains(line)) found << line;
}

/// Texts of visible widgets, and their tool tips, that hold English words.
QStringList englishTexts(const QWidget& window) {
  QStringList found;
  for (auto* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    addIfEnglish(found, *widget, widget->toolTip());
    if (auto* label = qobject_cast<QLabel*>(widget)) addIfEnglish(found, *label, label->text());
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) addIfEnglish(found, *button, button->text());
    if (auto* line = qobject_cast<QLineEdit*>(widget)) addIfEnglish(found, *line, line->placeholderText());
    if (auto* bar = qobject_cast<QTabBar*>(widget))
      for (int i = 0; i < bar->count(); ++i) addIfEnglish(found, *bar, bar->tabText(i));
    if (auto* menu = qobject_cast<QMenu*>(widget))
      for (auto* action : menu->actions()) addIfEnglish(found, *menu, action->text());
  }
  return found;
}

class JapaneseWindowTest : public LanguagesTest {
 protected:
  void SetUp() override {
    LanguagesTest::SetUp();
    if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    applyLanguage(*qApp, "ja");
    window_ = std::make_unique<MainWindow>(Services{});
    window_->resize(1600, 1000);
    window_->show();
    QApplication::processEvents();
  }
  void expectJapanese(const char* page) {
    QApplication::processEvents();
    if (const char* folder = std::getenv("FACENAV_GUI_PICTURES"))
      writeScreenshot(*window_, QString("%1/ja_%2.png").arg(folder, page));
    const QStringList found = englishTexts(*window_);
    EXPECT_TRUE(found.isEmpty()) << page << ":\n" << found.join("\n").toStdString();
  }
  testing::TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(JapaneseWindowTest, EveryWorkspaceIsInJapanese) {
  const auto prepared = fixtures::ballWithBrain();
  const auto store = casefile::CaseStore::create(folder_.path() / "case", prepared, {}, false);
  guidance::TreatmentPlan plan;
  plan.targets.push_back(guidance::planTarget("M1", prepared.scalp, Point<Mri>(-28, 4, 28), 0.8, 4.0));
  store.setTargets(plan);
  testing::writeMadeSession(store.folder(), plan.targets[0]);
  window_->openCaseAt(QString::fromStdString(store.folder().string()), PrepareStep::check);
  ASSERT_TRUE(fixtures::waitFor([&] { return window_->isSettled(); }));
  expectJapanese("check");
  window_->setPrepareStep(PrepareStep::worklist);
  expectJapanese("worklist");
  window_->setPrepareStep(PrepareStep::sign_off);
  expectJapanese("sign_off");
  window_->setWorkspace(Workspace::plan);
  expectJapanese("plan");
  window_->setWorkspace(Workspace::treat);
  expectJapanese("treat");
  window_->setWorkspace(Workspace::review);
  fixtures::waitFor([&] { return window_->review().session() && !window_->review().isReading(); }, 5000);
  expectJapanese("review");
}

TEST_F(JapaneseWindowTest, MenusAreInJapaneseAndAFontHasTheLetters) {
  for (auto* top : window_->menuBar()->actions()) {
    EXPECT_TRUE(englishWords(top->text()).isEmpty()) << top->text().toStdString();
    emit top->menu()->aboutToShow();
    for (auto* action : top->menu()->actions())
      EXPECT_TRUE(englishWords(action->text()).isEmpty() || action->text() == "English")
          << action->text().toStdString();
  }
  EXPECT_FALSE(QFontDatabase().families(QFontDatabase::Japanese).isEmpty())
      << "no font has Japanese letters: install fonts-vlgothic";
}

}  // namespace
}  // namespace facenav::ui
