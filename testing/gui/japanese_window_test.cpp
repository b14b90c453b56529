// Every page of the window in Japanese, without English words. FACENAV_GUI_PICTURES=DIR stores an image of
// each.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QFontDatabase>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTabBar>
#include <cstdlib>

#include "facenav/guidance/target.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "prepare/prepare_workspace.h"
#include "review/review_workspace.h"
#include "shell/language.h"
#include "shell/main_window.h"
#include "shell/screenshot.h"
#include "shell/users_words.h"
#include "support/made_session.h"

namespace facenav::ui {
namespace {

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

class JapaneseWindowTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    applyLanguage(*qApp, "ja");
    window_ = std::make_unique<MainWindow>(Services{});
    window_->resize(1600, 1000);
    window_->show();
    QApplication::processEvents();
  }
  void TearDown() override {
    window_.reset();
    applyLanguage(*qApp, "en");
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
