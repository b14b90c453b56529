// Every page, menu and dialog in Japanese, at 1366 x 768 with text of 100 and 150 %: no text is cut, no words
// stayed English, each letter has a font. FACENAV_GUI_PICTURES=DIR keeps an image of each.

#include <gtest/gtest.h>

#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QScreen>
#include <QSettings>
#include <QTableView>
#include <QToolButton>
#include <QtTest/QTest>
#include <cstdlib>

#include "every_page.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "home_and_setup_pages.h"
#include "plan/export_window.h"
#include "plan/import_window.h"
#include "prepare/prepare_workspace.h"
#include "prepare/worklist_page.h"
#include "review/review_workspace.h"
#include "shell/appearance.h"
#include "shell/help_window.h"
#include "shell/language.h"
#include "shell/main_window.h"
#include "support/coil_positions.h"
#include "support/english_texts.h"
#include "support/window_checks.h"
#include "treat/treat_workspace.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

constexpr QSize kLaptop{1366, 768};
constexpr double kScales[] = {1.0, 1.5};
constexpr int kTries = 10;

/// What a person wrote in the cases of these tests, and names that the tests' cameras have.
const QStringList kUsersWords{"A name that is rather long, Family, Given, born 1970-01-31",
                              "M1 hand L",
                              "M1 hand R",
                              "DLPFC left, by Beam F3, second try",
                              "recording: ",  // the folder of the live session
                              "one 60 mm marker",
                              "room 4"};

QStringList faultsOf(const QWidget& window) {
  return testing::cutTexts(window) + testing::misplacedParts(window) +
         testing::englishTexts(window, kUsersWords) + testing::unreadableTexts(window);
}

/// Looks at the window as it is now. A layout that follows the width of a text comes a moment later.
void lookAt(QWidget& window, const QString& page) {
  SCOPED_TRACE(page.toStdString());
  fixtures::settle();
  QStringList faults = faultsOf(window);
  for (int tries = 0; tries < kTries && !faults.isEmpty(); ++tries) {
    fixtures::settle();
    faults = faultsOf(window);
  }
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
    window.grab().save(QString("%1/ja_%2_%3.png").arg(pictures, page).arg(int(100 * textScale())));
  for (const QString& fault : faults) ADD_FAILURE() << fault.toStdString();
}

/// Looks at a window, made for the text of 100 %, in both sizes.
void lookInBothSizes(QWidget& window, const char* page) {
  for (const double scale : kScales) {
    changeTextScale(*qApp, scale);
    QTest::qWait(80);  // longer than the refresh of Home and the set-up
    lookAt(window, page);
    EXPECT_EQ(window.size(), kLaptop) << "no words widen the window: " << page;
  }
  changeTextScale(*qApp, 1.0);
}

class JapanesePages : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    QSettings().clear();
    applyLanguage(*qApp, "ja");
  }
  void TearDown() override {
    window_.reset();
    changeTextScale(*qApp, 1.0);
    applyLanguage(*qApp, "en");
    QSettings().clear();
  }
  void open(const std::filesystem::path& case_folder, const Services& services = {}) {
    window_ = std::make_unique<MainWindow>(services);
    window_->resize(kLaptop);
    window_->show();
    window_->setCasesFolder(QString::fromStdString(case_folder.parent_path().string()));
    window_->openCase(QString::fromStdString(case_folder.string()));
    ASSERT_TRUE(fixtures::waitFor([&] { return !window_->tasks().isRunning(); }));
  }
  /// Opens the menu and those in it, one after the other.
  void lookAtMenu(QMenu& menu, const QString& name) {
    menu.popup(window_->mapToGlobal({80, 40}));
    fixtures::layOut();
    const QRect screen = QGuiApplication::primaryScreen()->geometry();
    EXPECT_TRUE(screen.contains(menu.geometry())) << name.toStdString();
    lookAt(menu, name);
    const auto inside = menu.findChildren<QMenu*>();
    menu.close();
    for (int i = 0; i < inside.size(); ++i) lookAtMenu(*inside[i], name + QString("_%1").arg(i + 1));
  }
  void lookAtDialog(const char* object_name) {
    auto* dialog = window_->findChild<QDialog*>(object_name);
    ASSERT_TRUE(dialog && dialog->isVisible()) << object_name;
    lookAt(*dialog, object_name);
    dialog->reject();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  QString write(const std::string& name, const std::string& content) const {
    return QString::fromStdString(testing::writtenFile(folder_.path() / name, content).string());
  }
  testing::TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(JapanesePages, EveryPageAndTool) {
  ASSERT_NO_FATAL_FAILURE(open(fixtures::writeFullCase(folder_.path())));
  for (const double scale : kScales) {
    changeTextScale(*qApp, scale);
    for (const auto& page : fixtures::pagesAndTools()) {
      page.show(*window_);
      lookAt(*window_, page.name);
      EXPECT_EQ(window_->size(), kLaptop) << page.name;
    }
  }
}

TEST_F(JapanesePages, EveryMenu) {
  ASSERT_NO_FATAL_FAILURE(open(fixtures::writeFullCase(folder_.path())));
  window_->setWorkspace(Workspace::plan);
  for (const double scale : kScales) {
    changeTextScale(*qApp, scale);
    fixtures::settle();
    int number = 0;
    for (auto* action : window_->menuBar()->actions())
      lookAtMenu(*action->menu(), QString("menu_%1").arg(++number));
    for (auto* button : window_->findChildren<QToolButton*>())
      if (button->isVisible() && button->menu())
        lookAtMenu(*button->menu(), QString("plan_%1").arg(++number));
    EXPECT_GE(number, 4 + 7);
  }
}

TEST_F(JapanesePages, EveryDialog) {
  ASSERT_NO_FATAL_FAILURE(open(fixtures::writeFullCase(folder_.path())));
  for (const double scale : kScales) {
    changeTextScale(*qApp, scale);
    window_->setPrepareStep(PrepareStep::worklist);
    auto& worklist = *window_->findChild<WorklistPage*>();
    ASSERT_TRUE(fixtures::waitFor([&] { return worklist.canRemove(); }));
    worklist.removeChosen();
    lookAtDialog("delete_question");
    window_->setWorkspace(Workspace::review);
    ASSERT_TRUE(
        fixtures::waitFor([&] { return window_->review().session() && !window_->review().isReading(); }));
    QTableView* pulses = nullptr;
    for (auto* table : window_->findChildren<QTableView*>())
      if (table->isVisible() && table->contextMenuPolicy() == Qt::CustomContextMenu) pulses = table;
    ASSERT_TRUE(pulses);
    pulses->selectRow(1);
    emit pulses->customContextMenuRequested({20, 20});
    auto* menu = window_->findChild<QMenu*>("pulses_menu");
    ASSERT_TRUE(menu);
    lookAt(*menu, "pulses_menu");
    menu->actions().front()->trigger();
    menu->close();
    lookAtDialog("exclude_question");
    auto& help = HelpWindow::of(*window_);
    for (auto* action : window_->menuBar()->actions().back()->menu()->actions().mid(2)) {
      if (action->isSeparator()) continue;
      action->trigger();
      lookAt(help, "help_" + help.windowTitle());
    }
    help.close();
  }
}

TEST_F(JapanesePages, FilesOfOtherPrograms) {
  ASSERT_NO_FATAL_FAILURE(open(fixtures::writeFullCase(folder_.path())));
  window_->setWorkspace(Workspace::plan);
  const QString file = write("two.csv", testing::coilPosition("M1 hand L", {-1, 0, 1}) +
                                            testing::coilPosition("M1 hand R", {0, 0, 1}, 900));
  for (const double scale : kScales) {
    changeTextScale(*qApp, scale);
    window_->take({file});
    ASSERT_TRUE(fixtures::waitFor([&] {
      auto* shown = window_->findChild<ImportWindow*>();
      return shown && shown->isVisible() && !shown->presenter().isReading();
    }));
    auto* imports = window_->findChild<ImportWindow*>();
    imports->resize(kLaptop);
    lookAt(*imports, "import");
    imports->close();
    window_->exportOther();
    auto* exports = window_->findChild<ExportWindow*>();
    exports->resize(kLaptop);
    auto* formats = exports->findChild<QComboBox*>();
    for (int i = 0; i < formats->count(); ++i) {
      formats->setCurrentIndex(i);
      lookAt(*exports, QString("export_%1").arg(i + 1));
    }
    exports->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

/// Guidance on and off target, and with the face out of sight.
TEST_F(JapanesePages, ALiveSession) {
  namespace live = treat_fixtures;
  const auto sees_face = std::make_shared<std::atomic<bool>>(true);
  Services services = live::fakeServices();
  services.makeNavigator = [sees_face](const session::NavigatorSetup& setup) {
    return std::make_unique<session::Navigator>(
        setup, std::make_unique<live::fakes::Head>([sees_face](auto) {
          return *sees_face ? std::optional(RigidTransform<Camera, Head>()) : std::nullopt;
        }),
        std::make_unique<live::fakes::Coil>(live::kMarker));
  };
  const auto recording = QString::fromStdString(live::writeRecording(folder_.path(), 6000).string());
  ASSERT_NO_FATAL_FAILURE(open(live::plannedCase(folder_.path(), true), services));
  window_->play(recording, true);
  ASSERT_TRUE(fixtures::waitFor([&] { return window_->treat().isRunning(); }));
  window_->setWorkspace(Workspace::treat);
  auto* treat = window_->findChild<TreatWorkspace*>();
  for (const double scale : kScales) {
    changeTextScale(*qApp, scale);
    for (const auto& [tool, name] : {std::pair(TreatSide::Tool::aim, "live_aim"),
                                     {TreatSide::Tool::motor, "live_motor"},
                                     {TreatSide::Tool::session, "live_session"},
                                     {TreatSide::Tool::check, "live_check"}}) {
      treat->showTool(tool);
      QTest::qWait(150);
      lookAt(*window_, name);
    }
    *sees_face = false;
    treat->showTool(TreatSide::Tool::aim);
    ASSERT_TRUE(fixtures::waitFor([&] { return !window_->treat().state()->camera_T_mri; }));
    QTest::qWait(150);
    lookAt(*window_, "live_lost");
    window_->close();
    lookAtDialog("close_question");
    *sees_face = true;
    ASSERT_TRUE(fixtures::waitFor([&] { return bool(window_->treat().state()->camera_T_mri); }));
  }
  treat->presenter().stop("the test has ended");
}

TEST_F(JapanesePages, TheQuestionWhoThePatientIs) {
  namespace live = treat_fixtures;
  const std::string words =
      "not aligned: the face fits this MRI, but was measured too coarsely to tell this person from others "
      "(91 % of it lies on the skin, by 1.3 mm)";
  const std::string remedy =
      "bring the cameras nearer, project dots, and keep hair and hands off the face; or check name and date "
      "of "
      "birth, and confirm that this is the patient's own MRI";
  Services services = live::fakeServices();
  services.align = [words, remedy](const auto&, const auto&, const auto&, auto&) -> steps::AlignmentOutcome {
    throw registration::PersonUnclear(words, remedy);
  };
  const auto recording = QString::fromStdString(live::writeRecording(folder_.path(), 60).string());
  ASSERT_NO_FATAL_FAILURE(open(live::plannedCase(folder_.path(), true), services));
  window_->setWorkspace(Workspace::treat);
  window_->play(recording, false);
  const auto isAsked = [this] { return window_->findChild<QMessageBox*>("person_question") != nullptr; };
  for (const double scale : kScales) {
    changeTextScale(*qApp, scale);
    ASSERT_TRUE(fixtures::waitFor(isAsked));
    lookAtDialog("person_question");
    ASSERT_TRUE(fixtures::waitFor([&] { return !isAsked(); }));
    window_->findChild<TreatWorkspace*>()->presenter().align(false);
  }
  ASSERT_TRUE(fixtures::waitFor(isAsked));
}

TEST_F(JapanesePages, Home) { fixtures::onEveryHomePage(kLaptop, lookInBothSizes); }

TEST_F(JapanesePages, SetUpOfTheCameras) { fixtures::onEverySetUpPage(kLaptop, lookInBothSizes); }

}  // namespace
}  // namespace facenav::ui
