#include "prepare/worklist_table.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QtTest/QTest>
#include <fstream>

#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "prepare/sign_off_presenter.h"
#include "prepare/worklist_page.h"

namespace facenav::ui {
namespace {

namespace fs = std::filesystem;

class WorklistTest : public ::testing::Test {
 protected:
  WorklistTest() : queue_(services_), worklist_(queue_), table_(worklist_), filter_(table_) {
    QSettings().clear();
    queue_.setHeld(true);  // jobs stay queued
  }
  bool show(std::size_t rows) {
    worklist_.setFolder(QString::fromStdString(folder_.path().string()));
    return fixtures::waitFor([&] { return worklist_.rows().size() == rows; });
  }
  casefile::CaseStore makeCase(const std::string& name) {
    return casefile::CaseStore::create(folder_.path() / name, fixtures::ballCase(), {}, false);
  }
  testing::TemporaryFolder folder_;
  Services services_;
  PrepareQueue queue_;
  WorklistPresenter worklist_;
  WorklistTable table_;
  WorklistFilter filter_;
};

TEST_F(WorklistTest, FollowsTheFolderAsCasesComeAndAreSignedOff) {
  const auto store = makeCase("one");
  ASSERT_TRUE(show(1));
  EXPECT_EQ(worklist_.rows()[0].state, "prepared");
  EXPECT_EQ(worklist_.rows()[0].findings, 1);
  EXPECT_EQ(worklist_.rows()[0].age, "now");
  makeCase("two");
  ASSERT_TRUE(fixtures::waitFor([&] { return worklist_.rows().size() == 2; }));
  casefile::signOff(store, {"XY", "", true});
  ASSERT_TRUE(fixtures::waitFor([&] {
    for (const auto& row : worklist_.rows())
      if (row.checked_by == "XY" && row.state == "checked") return true;
    return false;
  }));
  fs::remove_all(folder_.path() / "two");
  ASSERT_TRUE(fixtures::waitFor([&] { return worklist_.rows().size() == 1; }));
}

TEST_F(WorklistTest, ShowsTheUnreadableWithItsReasonAndWhatIsQueued) {
  fs::create_directories(folder_.path() / "broken");
  std::ofstream(folder_.path() / "broken" / "case.json") << "{";
  fs::create_directories(folder_.path() / "dropped");
  queue_.add(QString::fromStdString((folder_.path() / "dropped").string()));
  ASSERT_TRUE(show(2));
  EXPECT_EQ(worklist_.rows()[0].state, "queued");
  EXPECT_EQ(worklist_.rows()[1].state, "unreadable");
  EXPECT_TRUE(worklist_.rows()[1].detail.contains("case.json"));
}

TEST_F(WorklistTest, NoButtonMovesWhenAnotherLineIsChosen) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  makeCase("one");
  fs::create_directories(folder_.path() / "dropped");
  queue_.add(QString::fromStdString((folder_.path() / "dropped").string()));
  ASSERT_TRUE(show(2));
  WorklistPage page(worklist_, queue_);
  page.resize(1150, 600);
  page.show();
  auto* view = page.findChild<QTableView*>();
  const auto places = [&](int line) {
    view->selectRow(line);
    QApplication::processEvents();
    std::vector<QRect> all;
    for (auto* button : page.findChildren<QPushButton*>())
      if (button->isVisible()) all.push_back(button->geometry());
    return all;
  };
  const auto of_first = places(0), of_second = places(1);
  EXPECT_EQ(of_first.size(), 6u) << "what does not apply is grey, not gone";
  EXPECT_EQ(of_first, of_second);
}

TEST_F(WorklistTest, TypingFiltersByEveryWord) {
  casefile::signOff(makeCase("one"), {"XY", "", true});
  makeCase("two");
  ASSERT_TRUE(show(2));
  EXPECT_EQ(filter_.rowCount(), 2);
  filter_.setWords("check xy");
  ASSERT_EQ(filter_.rowCount(), 1);
  EXPECT_EQ(filter_.row(filter_.index(0, 0)).checked_by, "XY");
  filter_.setWords("checked prepared");
  EXPECT_EQ(filter_.rowCount(), 0);
}

TEST_F(WorklistTest, ACaseIsLabelledInPlaceAndFoundByItsLabel) {
  const auto store = makeCase("one");
  ASSERT_TRUE(show(1));
  const auto name = table_.index(0, WorklistTable::name);
  EXPECT_EQ(name.data().toString().toStdString(), store.caseId());
  EXPECT_TRUE(name.flags() & Qt::ItemIsEditable);
  EXPECT_FALSE(table_.index(0, WorklistTable::state).flags() & Qt::ItemIsEditable);
  QString refusal;
  QObject::connect(&worklist_, &WorklistPresenter::refused, [&](const QString& words) { refusal = words; });
  table_.setData(name, "Doe, Jane", Qt::EditRole);
  ASSERT_TRUE(fixtures::waitFor([&] { return worklist_.rows()[0].name == "Doe, Jane"; }));
  EXPECT_EQ(store.label(), "Doe, Jane");
  filter_.setWords("jane");
  EXPECT_EQ(filter_.rowCount(), 1);
  table_.setData(name, QString(200, 'x'), Qt::EditRole);
  EXPECT_TRUE(refusal.contains("longer than 120")) << refusal.toStdString();
  EXPECT_EQ(store.label(), "Doe, Jane");
}

TEST_F(WorklistTest, TheRestKeepsItsPlaceWhenALineComesOrGoes) {
  makeCase("one");
  makeCase("two");
  ASSERT_TRUE(show(2));
  const QPersistentModelIndex kept(table_.index(1, WorklistTable::name));
  const QString folder = table_.row(1).case_folder;
  makeCase("three");
  ASSERT_TRUE(fixtures::waitFor([&] { return table_.rowCount() == 3; }));
  fs::remove_all(table_.row(kept.row() == 0 ? 1 : 0).case_folder.toStdString());
  ASSERT_TRUE(fixtures::waitFor([&] { return table_.rowCount() == 2; }));
  ASSERT_TRUE(kept.isValid());
  EXPECT_EQ(table_.row(kept.row()).case_folder, folder);
}

TEST_F(WorklistTest, ALabelBeingTypedOutlivesTheListsRefreshAndReturnOnlyStoresIt) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto store = makeCase("one");
  ASSERT_TRUE(show(1));
  WorklistPage page(worklist_, queue_);
  page.resize(900, 400);
  page.show();
  QApplication::processEvents();
  QApplication::setActiveWindow(&page);
  int openings = 0;
  QObject::connect(&page, &WorklistPage::caseChosen, [&] { ++openings; });
  auto* view = page.findChild<QTableView*>();
  view->setFocus();
  view->selectRow(0);
  QTest::keyClick(view, Qt::Key_F2);
  const QPointer<QLineEdit> editor = view->viewport()->findChild<QLineEdit*>();
  ASSERT_TRUE(editor);
  QTest::keyClicks(editor, "Doe");
  emit queue_.changed();  // this happens every 30 s
  EXPECT_EQ(editor->text(), "Doe");
  fs::create_directories(folder_.path() / "dropped");
  queue_.add(QString::fromStdString((folder_.path() / "dropped").string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return view->model()->rowCount() == 2; }));
  ASSERT_TRUE(editor);
  QTest::keyClicks(editor, " J");
  QTest::keyClick(editor, Qt::Key_Return);
  EXPECT_EQ(openings, 0);
  EXPECT_EQ(store.label(), "Doe J");
  QTest::keyClick(view, Qt::Key_Return);
  EXPECT_EQ(openings, 1);
}

/// Texts of a menu's actions, without their keys.
QStringList actionTexts(const QMenu& menu) {
  QStringList words;
  for (const auto* action : menu.actions())
    if (!action->isSeparator()) words << action->text().section('\t', 0, 0);
  return words;
}

void chooseAction(const QMenu& menu, const QString& begin) {
  for (auto* action : menu.actions())
    if (action->text().startsWith(begin)) return action->trigger();
  ADD_FAILURE() << "no action " << begin.toStdString();
}

/// Opens the context menu of the table's first line.
QMenu* menuOfFirstLine(WorklistPage& page) {
  auto* view = page.findChild<QTableView*>();
  view->selectRow(0);
  emit view->customContextMenuRequested({20, 20});
  auto* menu = page.findChild<QMenu*>("worklist_menu");
  if (!menu) return nullptr;
  menu->setObjectName({});  // the next one is found by its name
  menu->close();
  return menu;
}

TEST_F(WorklistTest, AContextMenuOpensSignsOffAndLabelsACase) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  makeCase("one");
  ASSERT_TRUE(show(1));
  WorklistPage page(worklist_, queue_);
  page.resize(900, 400);
  page.show();
  QString opened, to_sign;
  QObject::connect(&page, &WorklistPage::caseChosen, [&](const QString& folder) { opened = folder; });
  QObject::connect(&page, &WorklistPage::signOffWanted, [&](const QString& folder) { to_sign = folder; });
  const auto* menu = menuOfFirstLine(page);
  ASSERT_TRUE(menu);
  EXPECT_EQ(actionTexts(*menu),
            (QStringList{"Open", "Sign off, or reject the scan\u2026", "Label\u2026", "Delete\u2026"}));
  chooseAction(*menu, "Open");
  EXPECT_EQ(opened, worklist_.rows()[0].case_folder);
  chooseAction(*menu, "Sign off");
  EXPECT_EQ(to_sign, worklist_.rows()[0].case_folder);
  chooseAction(*menu, "Label");
  EXPECT_TRUE(page.findChild<QTableView*>()->viewport()->findChild<QLineEdit*>());
}

TEST_F(WorklistTest, ACaseGoesToTheTrashOnlyAfterAQuestionAndNeverWhileItIsOpen) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto folder = makeCase("one").folder();
  ASSERT_TRUE(show(1));
  QString refused, said;
  QObject::connect(&worklist_, &WorklistPresenter::refused, [&](const QString& words) { refused = words; });
  QObject::connect(&worklist_, &WorklistPresenter::said, [&](const QString& words) { said = words; });
  WorklistPage page(worklist_, queue_);
  page.resize(900, 400);
  page.show();
  const auto answer = [&](const QString& words) {
    auto* menu = menuOfFirstLine(page);
    chooseAction(*menu, "Delete");
    auto* question = page.findChild<QMessageBox*>("delete_question");
    ASSERT_TRUE(question);
    EXPECT_TRUE(question->informativeText().contains("can be restored"));
    EXPECT_EQ(question->defaultButton()->text(), "Keep it");
    question->setObjectName({});
    for (auto* button : question->buttons())
      if (button->text() == words) button->click();
  };
  answer("Keep it");
  EXPECT_TRUE(fs::exists(folder / "case.json"));
  worklist_.setOpenCase(QString::fromStdString(folder.string()));
  answer("Move to the trash");
  EXPECT_TRUE(fs::exists(folder / "case.json"));
  EXPECT_TRUE(refused.contains("is open")) << refused.toStdString();
  worklist_.setOpenCase({});
  answer("Move to the trash");
  EXPECT_FALSE(fs::exists(folder)) << refused.toStdString();
  EXPECT_TRUE(fixtures::waitFor([&] { return worklist_.rows().empty(); }));
  const fs::path kept = said.section(": ", 1).toStdString();
  EXPECT_TRUE(fs::exists(kept / "case.json")) << "it can be restored: " << said.toStdString();
  fs::remove_all(kept);
  EXPECT_EQ(worklist_.moveToTrash("/tmp"), "") << "only a case of the list";
}

TEST_F(WorklistTest, AFolderThatCannotBeReadIsSaid) {
  worklist_.setFolder("/proc/nowhere");
  ASSERT_TRUE(fixtures::waitFor([&] { return !worklist_.problem().isEmpty(); }));
  EXPECT_TRUE(worklist_.rows().empty());
}

TEST(Age, IsInWords) {
  const QDateTime now(QDate(2026, 11, 21), QTime(12, 0), Qt::UTC);
  EXPECT_EQ(ageInWords(now.addSecs(-20), now), "now");
  EXPECT_EQ(ageInWords(now.addSecs(-12 * 60), now), "12 min");
  EXPECT_EQ(ageInWords(now.addSecs(-3 * 3600), now), "3 h");
  EXPECT_EQ(ageInWords(now.addDays(-5), now), "5 days");
  EXPECT_EQ(ageInWords(now.addDays(-35), now), "5 weeks");
}

class SignOffPresenterTest : public ::testing::Test {
 protected:
  SignOffPresenterTest() : presenter_(model_, tasks_) {
    QSettings().clear();
    model_.open(fixtures::loadBallCase(folder_.path()));
    QObject::connect(&tasks_, &TaskRunner::failed, [this](const QString& words) { failure_ = words; });
  }
  void tickAll() {
    for (int i = 0; i < presenter_.items().size(); ++i) presenter_.setSeen(i, true);
  }
  void waitForTask() {
    fixtures::waitFor([&] { return !tasks_.isRunning(); });
  }
  testing::TemporaryFolder folder_;
  CaseModel model_;
  TaskRunner tasks_;
  SignOffPresenter presenter_;
  QString failure_;
};

TEST_F(SignOffPresenterTest, NeedsEveryTickAndAName) {
  ASSERT_EQ(presenter_.items().size(), 2);  // the outlines and the ball's one finding
  presenter_.setName("XY");
  EXPECT_FALSE(presenter_.canSign());
  presenter_.setSeen(0, true);
  EXPECT_FALSE(presenter_.canSign());
  presenter_.sign();
  EXPECT_FALSE(tasks_.isRunning());
  presenter_.setSeen(1, true);
  EXPECT_TRUE(presenter_.canSign());
  presenter_.setName("  ");
  EXPECT_FALSE(presenter_.canSign());
}

TEST_F(SignOffPresenterTest, SignsInTheCaseAndRemembersTheName) {
  tickAll();
  presenter_.setName("XY");
  presenter_.setNote("nose tip is fine");
  presenter_.sign();
  waitForTask();
  EXPECT_TRUE(presenter_.holds());
  EXPECT_TRUE(presenter_.statusWords().startsWith("checked "));
  EXPECT_TRUE(model_.mayBeTreated());
  const auto stored = casefile::validSignOff(model_.current().store);
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->by, "XY");
  EXPECT_EQ(stored->note, "nose tip is fine");
  EXPECT_EQ(SignOffPresenter(model_, tasks_).name(), "XY");
}

TEST_F(SignOffPresenterTest, AScanIsRejectedWithNameAndReason) {
  presenter_.setName("XY");
  EXPECT_FALSE(presenter_.canReject()) << "without a reason";
  presenter_.setNote("the head moved");
  ASSERT_TRUE(presenter_.canReject());
  presenter_.reject();
  waitForTask();
  EXPECT_FALSE(presenter_.holds());
  EXPECT_TRUE(presenter_.statusWords().contains("rejected")) << presenter_.statusWords().toStdString();
  EXPECT_TRUE(presenter_.statusWords().contains("the head moved"));
  EXPECT_EQ(casefile::stateOf(model_.current().store), casefile::CaseState::rejected);
}

TEST_F(SignOffPresenterTest, IsRefusedWhenTheFilesAreNoLongerThoseShown) {
  std::ofstream(model_.current().store.folder() / "scalp.vtp", std::ios::app) << " ";
  tickAll();
  presenter_.setName("XY");
  presenter_.sign();
  waitForTask();
  EXPECT_FALSE(presenter_.holds());
  EXPECT_TRUE(failure_.contains("changed since they were shown"));
}

TEST_F(SignOffPresenterTest, SaysWhatMadeItVoid) {
  casefile::signOff(model_.current().store, {"XY", "", true});
  std::ofstream(model_.current().store.folder() / "scalp.vtp", std::ios::app) << " ";
  TaskMonitor monitor;
  model_.open(loadCase(model_.current().store.folder(), monitor));
  EXPECT_TRUE(presenter_.isVoid());
  EXPECT_FALSE(model_.mayBeTreated());
  EXPECT_TRUE(presenter_.statusWords().contains("scalp.vtp"));
  EXPECT_TRUE(presenter_.statusWords().contains("XY"));
}

}  // namespace
}  // namespace facenav::ui
