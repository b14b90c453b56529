// The menus of the main window: Edit works on what has the focus or on the page, View remembers the text size
// and keeps pictures, Help shows the manual, the shortcuts that there are, and what the program is made of.

#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QDir>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QShortcut>
#include <QTextBlock>
#include <QTextDocument>
#include <QtTest/QTest>

#include "facenav/core/licences.h"
#include "facenav/core/whole_file.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "prepare/prepare_workspace.h"
#include "review/review_workspace.h"
#include "shell/appearance.h"
#include "shell/help_window.h"
#include "shell/main_window.h"
#include "shell/manual_text.h"
#include "shell/screenshot.h"
#include "support/made_session.h"
#include "treat/treat_side.h"

namespace facenav::ui {
namespace {

class MenusTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    QSettings().clear();
    window_ = std::make_unique<MainWindow>(Services{});
    window_->show();
    QApplication::setActiveWindow(window_.get());
    QApplication::processEvents();
  }
  QMenu* menu(const QString& name) {
    for (auto* action : window_->menuBar()->actions())
      if (QString(action->text()).remove('&') == name) return action->menu();
    return nullptr;
  }
  /// The action whose text begins so, after the menu has been asked to open.
  QAction* action(const QString& menu_name, const QString& begin) {
    emit menu(menu_name)->aboutToShow();
    for (auto* each : menu(menu_name)->actions())
      if (QString(each->text()).remove('&').startsWith(begin)) return each;
    return nullptr;
  }
  /// Compares each widget's limits and letters with those of a window that starts with the text size in
  /// force.
  void expectAsIfStartedSo() {
    MainWindow started{Services{}};
    started.show();
    QApplication::processEvents();
    const auto changed = window_->findChildren<QWidget*>(), fresh = started.findChildren<QWidget*>();
    ASSERT_EQ(changed.size(), fresh.size());
    for (int i = 0; i < fresh.size(); ++i) {
      const std::string name =
          std::string(fresh[i]->metaObject()->className()) + " " + fresh[i]->objectName().toStdString();
      ASSERT_STREQ(changed[i]->metaObject()->className(), fresh[i]->metaObject()->className());
      // Qt's own bars of a scroll area change places among its children when one comes into view.
      if (fresh[i]->objectName().startsWith("qt_scrollarea")) continue;
      EXPECT_EQ(changed[i]->minimumSize(), fresh[i]->minimumSize()) << name;
      EXPECT_EQ(changed[i]->maximumSize(), fresh[i]->maximumSize()) << name;
      EXPECT_EQ(changed[i]->font().pointSizeF(), fresh[i]->font().pointSizeF()) << name;
    }
  }
  HelpWindow& help() { return HelpWindow::of(*window_); }
  std::unique_ptr<MainWindow> window_;
};

TEST_F(MenusTest, EditWorksOnTheTextThatHasTheFocus) {
  auto* field = window_->findChildren<QLineEdit*>().front();
  for (auto* each : window_->findChildren<QLineEdit*>())
    if (each->isVisible()) field = each;
  ASSERT_TRUE(field->isVisible());
  EXPECT_FALSE(action("Edit", "Undo")->isEnabled());
  field->setFocus();
  QTest::keyClicks(field, "abc");
  ASSERT_TRUE(action("Edit", "Undo")->isEnabled());
  EXPECT_FALSE(action("Edit", "Cut")->isEnabled());
  action("Edit", "Select all")->trigger();
  action("Edit", "Cut")->trigger();
  EXPECT_EQ(field->text(), "");
  EXPECT_EQ(QApplication::clipboard()->text(), "abc");
  action("Edit", "Undo")->trigger();
  EXPECT_EQ(field->text(), "abc");
  EXPECT_TRUE(action("Edit", "Undo")->text().endsWith("\tCtrl+Z")) << "the key is shown";
  EXPECT_TRUE(action("Edit", "Undo")->shortcut().isEmpty()) << "the key belongs to fields and pages";
}

TEST_F(MenusTest, EditUndoesWhatThePageDidAndNamesIt) {
  testing::TemporaryFolder folder;
  const auto prepared = fixtures::ballWithBrain();
  const auto store = casefile::CaseStore::create(folder.path() / "case", prepared, {}, false);
  guidance::TreatmentPlan plan;
  plan.targets.push_back(guidance::planTarget("M1", prepared.scalp, Point<Mri>(-28, 4, 28), 0.8, 4.0));
  store.setTargets(plan);
  testing::writeMadeSession(store.folder(), plan.targets[0], {});
  window_->openCase(QString::fromStdString(store.folder().string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return !window_->tasks().isRunning(); }, 60000));
  window_->setWorkspace(Workspace::review);
  auto& review = window_->review();
  ASSERT_TRUE(fixtures::waitFor([&] { return review.session() && !review.isReading(); }));
  EXPECT_FALSE(action("Edit", "Undo")->isEnabled());
  review.exclude({1}, "the coil slipped", "XY");
  ASSERT_TRUE(action("Edit", "Undo: exclude 1 pulse"));
  action("Edit", "Undo")->trigger();
  EXPECT_FALSE(review.editor().canUndo());
  EXPECT_TRUE(action("Edit", "Redo")->isEnabled());
  window_->setWorkspace(Workspace::treat);
  EXPECT_FALSE(action("Edit", "Redo")->isEnabled()) << "Treat has nothing to undo";
}

TEST_F(MenusTest, AnotherTextSizeHoldsAtOnceAndAtTheNextStart) {
  auto* sizes = action("View", "Text size")->menu();
  QString checked;
  for (auto* each : sizes->actions())
    if (each->isChecked()) checked += each->text();
  EXPECT_EQ(checked, "100 %");
  for (auto* each : sizes->actions())
    if (each->text() == "150 %") each->trigger();
  EXPECT_DOUBLE_EQ(rememberedTextScale(), 1.5);
  EXPECT_DOUBLE_EQ(textScale(), 1.5);
  QApplication::processEvents();
  expectAsIfStartedSo();
  for (auto* each : sizes->actions())
    if (each->text() == "100 %") each->trigger();
  QApplication::processEvents();
  expectAsIfStartedSo();
  QSettings().clear();
}

TEST_F(MenusTest, ResetGivesTheWindowItsFirstSize) {
  const QSize first = window_->size();
  window_->resize(1300, 700);
  action("View", "Reset the layout")->trigger();
  EXPECT_EQ(window_->size(), first);
}

TEST_F(MenusTest, APictureOfTheWindowIsForItsOwnerAlone) {
  testing::TemporaryFolder folder;
  const auto path = folder.path() / "window.png";
  writeScreenshot(*window_, QString::fromStdString(path.string()));
  EXPECT_EQ(QImage(QString::fromStdString(path.string())).size(), window_->size());
  EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms(0600));
  EXPECT_THROW(writeScreenshot(*window_, "/nowhere/window.png"), Error);
}

TEST_F(MenusTest, F1ShowsTheManualWhereItDescribesThePageInView) {
  const std::pair<Workspace, QString> pages[] = {{Workspace::prepare, "prepare.md"},
                                                 {Workspace::plan, "plan.md"},
                                                 {Workspace::treat, "treat.md"},
                                                 {Workspace::review, "review.md"}};
  for (const auto& [workspace, page] : pages) {
    window_->setWorkspace(workspace);
    QApplication::setActiveWindow(window_.get());
    QTest::keyClick(window_.get(), Qt::Key_F1);
    EXPECT_EQ(help().page(), page);
    EXPECT_TRUE(help().isVisible());
    EXPECT_TRUE(help().text().contains("In the window")) << page.toStdString();
    help().close();
  }
}

TEST_F(MenusTest, F1ShowsTheSectionOfThePageAndToolInView) {
  using Tool = TreatSide::Tool;
  const auto shown = [&] {
    for (auto* widget : window_->findChildren<QWidget*>()) widget->clearFocus();
    window_->showHelp();
    return help().page() + "#" + help().heading();
  };
  const auto at = [&](Workspace workspace) { window_->setWorkspace(workspace); };
  const std::pair<PrepareStep, QString> steps[] = {
      {PrepareStep::worklist, "prepare.md#in-the-window"},
      {PrepareStep::series, "prepare.md#look-what-a-folder-holds-facenav-series"},
      {PrepareStep::archive, "prepare.md#fetch-a-series-from-the-archive-facenav-pacs"},
      {PrepareStep::check, "prepare.md#check-and-sign-off-facenav-check"},
      {PrepareStep::sign_off, "prepare.md#check-and-sign-off-facenav-check"}};
  at(Workspace::prepare);
  for (const auto& [step, place] : steps) {
    window_->setPrepareStep(step);
    EXPECT_EQ(shown(), place);
  }
  const std::pair<Tool, QString> tools[] = {{Tool::aim, "treat.md#in-the-window"},
                                            {Tool::motor, "treat.md#the-motor-threshold-facenav-threshold"},
                                            {Tool::session, "treat.md#where-pulses-come-from"},
                                            {Tool::check, "treat.md#judge-the-alignment"}};
  at(Workspace::treat);
  for (const auto& [tool, place] : tools) {
    window_->findChild<TreatSide*>()->showTool(tool);
    EXPECT_EQ(shown(), place);
  }
  const std::pair<ReviewPage, QString> pages[] = {
      {ReviewPage::pulses, "review.md#the-pulses-facenav-pulses"},
      {ReviewPage::replay, "review.md#in-the-window"},
      {ReviewPage::compare, "review.md#in-the-window"},
      {ReviewPage::report, "review.md#for-the-chart-facenav-report"}};
  at(Workspace::review);
  for (const auto& [page, place] : pages) {
    window_->findChild<ReviewWorkspace*>()->setPage(page);
    EXPECT_EQ(shown(), place);
  }
  at(Workspace::plan);
  EXPECT_EQ(shown(), "plan.md#in-the-window");
}

TEST_F(MenusTest, EveryPartWithAPlaceOfItsOwnNamesAHeadingThatExists) {
  int parts = 0;
  for (const auto* part : window_->findChildren<QWidget*>()) {
    const QString page = part->property("help_page").toString();
    if (page.isEmpty()) continue;
    ++parts;
    ASSERT_TRUE(HelpWindow::showPlaceOf(part, *window_));
    EXPECT_EQ(help().page(), page);
    EXPECT_EQ(help().heading(), part->property("help_heading").toString());
  }
  EXPECT_GE(parts, 6) << "overlays, field, dose, field's view, targets' tools, brain's edits";
}

TEST_F(MenusTest, HelpShowsThePicturesThatAreInstalledAndLeavesOutTheOthers) {
  testing::TemporaryFolder folder;
  const auto pictures = folder.path() / "doc" / "facenav" / "manual" / "html" / "_images";
  std::filesystem::create_directories(pictures);
  qputenv("FACENAV_DATA", QByteArray::fromStdString((folder.path() / "facenav").string()));
  const auto countPictures = [](const QString& page) {
    ManualText text(nullptr);
    text.resize(700, 500);
    text.showPage(page);
    int count = 0;
    for (auto block = text.document()->begin(); block.isValid(); block = block.next())
      for (auto it = block.begin(); !it.atEnd(); ++it)
        if (it.fragment().charFormat().isImageFormat()) {
          ++count;
          const auto name = it.fragment().charFormat().toImageFormat().name();
          const auto shown = text.document()->resource(QTextDocument::ImageResource, name).value<QImage>();
          EXPECT_EQ(shown.width(), 640) << "at most as wide as the window";
        }
    EXPECT_FALSE(text.toPlainText().contains("picture:"));
    return count;
  };
  QImage large(1366, 768, QImage::Format_RGB32);
  large.fill(Qt::blue);
  ASSERT_TRUE(large.save(QString::fromStdString((pictures / "here.png").string())));
  EXPECT_EQ(countPictures("# A\n\n<!-- picture: here what it shows -->\n\nB\n"), 1);
  EXPECT_EQ(countPictures("# A\n\n<!-- picture: away what it shows -->\n\nB\n"), 0);
  qunsetenv("FACENAV_DATA");
}

TEST_F(MenusTest, EveryPageOfTheManualIsInTheProgramAndItsLinksLeadToPages) {
  const QDir manual(QString(FACENAV_SOURCE_DIR) + "/resources/doc");
  const QStringList pages = manual.entryList({"*.md"});
  ASSERT_GT(pages.size(), 10);
  static const QRegularExpression kLink("\\]\\(([a-z-]+\\.md)");
  for (const QString& page : pages) {
    help().showPage(page);
    EXPECT_EQ(help().page(), page);
    EXPECT_FALSE(help().text().startsWith('#')) << "shown as a page, not as its source";
    const auto text = QString::fromStdString(readWholeFile(manual.filePath(page).toStdString()));
    for (auto it = kLink.globalMatch(text); it.hasNext();) {
      const QString link = it.next().captured(1);
      EXPECT_TRUE(pages.contains(link) && QFile::exists(":/facenav/doc/" + link)) << link.toStdString();
    }
  }
}

TEST_F(MenusTest, TheListOfShortcutsHoldsEveryKeyOfTheWindow) {
  QStringList listed;
  for (const auto& line : window_->shortcuts()) {
    listed += line.keys.split(", ");
    EXPECT_FALSE(line.words.isEmpty()) << line.page.toStdString() << " " << line.keys.toStdString();
  }
  const auto expectListed = [&](const QKeySequence& keys) {
    const QString text = keys.toString(QKeySequence::NativeText);
    if (!text.isEmpty()) {
      EXPECT_TRUE(listed.contains(text)) << text.toStdString();
    }
  };
  for (const auto* each : window_->findChildren<QShortcut*>()) expectListed(each->key());
  for (const auto* each : window_->findChildren<QAbstractButton*>()) expectListed(each->shortcut());
  for (const auto* each : window_->findChildren<QAction*>()) expectListed(each->shortcut());
  EXPECT_GT(listed.size(), 50);
  action("Help", "Keyboard shortcuts")->trigger();
  for (const char* words : {"Everywhere", "Help for this page", "F1", "one frame back", "Ctrl+Return"})
    EXPECT_TRUE(help().text().contains(words)) << words;
}

TEST_F(MenusTest, AboutNamesVersionBuildAndTheLicenceOfEveryPart) {
  QApplication::setApplicationVersion("0.1.0 (commit 1a2b3c4d)");
  action("Help", "About FaceNav")->trigger();
  for (const char* words :
       {"Version 0.1.0 (commit 1a2b3c4d)", "Built for", "Apache-2.0", "Not a medical device", "LGPL-3.0"})
    EXPECT_TRUE(help().text().contains(words)) << words;
  const auto loaded = QString::fromStdString(readWholeFile("/proc/self/maps"));
  for (const LicensedPart& part : licensedParts()) {
    EXPECT_TRUE(help().text().contains(QString::fromStdString(part.name))) << part.name;
    EXPECT_TRUE(help().text().contains(QString::fromStdString(part.licence))) << part.name;
    if (part.use == PartUse::linked_in_lab) continue;
    for (const std::string& library : part.libraries)
      EXPECT_TRUE(loaded.contains("/" + QString::fromStdString(library))) << part.name;
  }
}

}  // namespace
}  // namespace facenav::ui
