// Review: sessions, pulses, replay, comparison and report in the window, on sessions of known content.

#include <gmock/gmock.h>

#include <QCheckBox>
#include <QComboBox>
#include <QInputDialog>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/csv_table.h"
#include "facenav/core/whole_file.h"
#include "facenav/home/home_case.h"
#include "facenav/scene/display.h"
#include "pdf_text.h"
#include "review/pulse_table.h"
#include "review/review_workspace.h"
#include "review/sessions_panel.h"
#include "review_fixtures.h"
#include "shell/main_window.h"
#include "shell/scene_view.h"

namespace facenav::ui {
namespace {

using namespace review_fixtures;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(ReviewTest, TheNewestSessionIsShownWithThePulsesOfItsFile) {
  ReviewPresenter review(model_);
  review.refresh();
  waitForSession(review);
  ASSERT_EQ(review.sessions().size(), 2u);
  EXPECT_EQ(review.chosen().toStdString(), second_.filename().string());
  PulseTable table(review);
  ASSERT_EQ(table.rowCount(), 40);
  const auto session = casefile::readSession(second_);
  for (int row = 0; row < 40; ++row) {
    const auto& pulse = session.pulses.pulses[std::size_t(row)].pulse;
    const auto shown = table.index(row, PulseTable::columnOf(report::PulseColumn::distance))
                           .data(Qt::DisplayRole)
                           .toString();
    if (pulse.offset)
      EXPECT_NEAR(shown.toDouble(), pulse.offset->distance_mm, 0.0501) << row;
    else
      EXPECT_EQ(shown, "") << "a lost pulse has no error";
  }
  ASSERT_TRUE(review.session()->map);
  EXPECT_NEAR(review.session()->map->centre_of_gravity.mm.norm(), 40, 3) << "on the brain";
}

TEST_F(ReviewTest, ExclusionsNeedAReasonAreWrittenAndCanBeUndone) {
  ReviewPresenter review(model_);
  QString refused;
  QObject::connect(&review, &ReviewPresenter::refused, [&](const QString& words) { refused = words; });
  review.refresh();
  waitForSession(review);
  review.exclude({3, 4}, "  ", "AB");
  EXPECT_THAT(refused.toStdString(), HasSubstr("only with a reason"));
  EXPECT_FALSE(fs::exists(second_ / "pulse_edits.jsonl"));
  review.exclude({3, 4}, "patient moved", "AB");
  ASSERT_TRUE(fixtures::waitFor([&] { return review.sessions().back().excluded == 2; }));
  ASSERT_TRUE(fixtures::waitFor([&] { return review.session()->kept.pulses.pulses[2].is_excluded; }));
  EXPECT_EQ(review.session()->kept.pulses.pulses.size(), 40u) << "nothing is deleted";
  review.undo();
  ASSERT_TRUE(fixtures::waitFor([&] { return review.sessions().back().excluded == 0; }));
  EXPECT_FALSE(casefile::readSessionPulses(second_).pulses[2].is_excluded);
}

/// Opens the context menu of the pulses and chooses the action whose text begins so.
void chooseInMenu(SessionsPanel& panel, const QString& begin) {
  QTableView* pulses = nullptr;
  for (auto* view : panel.findChildren<QTableView*>())
    if (view->accessibleName() == "pulses") pulses = view;
  emit pulses->customContextMenuRequested({20, 20});
  auto* menu = panel.findChild<QMenu*>("pulses_menu");
  ASSERT_TRUE(menu);
  menu->setObjectName({});  // the next one is found by its name
  menu->close();
  for (auto* action : menu->actions())
    if (action->text().startsWith(begin)) return action->trigger();
  ADD_FAILURE() << "no action " << begin.toStdString();
}

TEST_F(ReviewTest, AContextMenuExcludesPulsesForAReasonTakesThemInAndShowsOne) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  ReviewPresenter review(model_);
  SessionsPanel panel(review);
  panel.show();
  review.refresh();
  waitForSession(review);
  bool wants_replay = false;
  QObject::connect(&panel, &SessionsPanel::replayWanted, [&] { wants_replay = true; });
  review.mark(3);  // selects its line
  chooseInMenu(panel, "Exclude");
  auto* question = panel.findChild<QInputDialog*>("exclude_question");
  ASSERT_TRUE(question) << "an exclusion needs a reason";
  EXPECT_FALSE(fs::exists(second_ / "pulse_edits.jsonl"));
  question->setTextValue("patient moved");
  question->accept();
  ASSERT_TRUE(fixtures::waitFor([&] { return review.session()->kept.pulses.pulses[2].is_excluded; }));
  chooseInMenu(panel, "Show in the replay");
  EXPECT_TRUE(wants_replay);
  EXPECT_EQ(review.marked(), 3);
  chooseInMenu(panel, "Take in");
  ASSERT_TRUE(fixtures::waitFor([&] { return !review.session()->kept.pulses.pulses[2].is_excluded; }));
}

TEST_F(ReviewTest, AFileThatCameBackFromHomeIsAddedShownAndMarked) {
  const auto home = casefile::CaseStore::createFromFace(
      folder_.path() / "home", {fixtures::ballWithBrain().scalp, {}, "", model_.current().store.caseId()}, {},
      false);
  testing::MadeSession made;
  made.pulses = 17;
  const auto session = testing::writeMadeSession(home.folder(), someTarget(fixtures::ballWithBrain()), made);
  const auto file = folder_.path() / "back.zip";
  steps::writeSendBack(home, session, file);
  ReviewPresenter review(model_);
  QString said, refused;
  QObject::connect(&review, &ReviewPresenter::said, [&](const QString& words) { said = words; });
  QObject::connect(&review, &ReviewPresenter::refused, [&](const QString& words) { refused = words; });
  review.refresh();
  waitForSession(review);
  review.addReturned(QString::fromStdString(file.string()));
  EXPECT_THAT(said.toStdString(), HasSubstr("17 pulses: added to the case"));
  ASSERT_TRUE(fixtures::waitFor(
      [&] { return review.sessions().size() == 3 && review.session() && !review.isReading(); }));
  EXPECT_EQ(review.session()->kept.pulses.pulses.size(), 17u);
  EXPECT_TRUE(review.session()->kept.returned_utc);
  EXPECT_EQ(std::count_if(review.sessions().begin(), review.sessions().end(),
                          [](const auto& s) { return s.is_at_home; }),
            1);
  std::ofstream(file, std::ios::app) << "damaged";
  std::filesystem::resize_file(file, 500);
  review.addReturned(QString::fromStdString(file.string()));
  EXPECT_THAT(refused.toStdString(), HasSubstr("back.zip"));
}

TEST_F(ReviewTest, ReplayShowsTheFilesNumbersAndALossAsLost) {
  ReviewPresenter review(model_);
  ReplayPresenter replay(review, model_);
  review.choose(QString::fromStdString(first_.filename().string()));
  waitForSession(review);
  replay.open();
  ASSERT_TRUE(fixtures::waitFor([&] { return replay.isOpen(); }));
  replay.goTo(123);
  const CsvTable guidance(first_ / "guidance.csv");
  EXPECT_THAT(
      replay.figures().toStdString(),
      HasSubstr("error " +
                QString::number(guidance.number(123, guidance.column("distance_mm")), 'f', 1).toStdString() +
                " mm"));
  EXPECT_THAT(replay.timeWords().toStdString(), HasSubstr("frame 123"));
  EXPECT_EQ(replay.lossWords(), "");
  replay.goTo(230);
  EXPECT_EQ(replay.lossWords(), "face lost: no_face");
  EXPECT_THAT(replay.figures().toStdString(), Not(HasSubstr("mm")));
  replay.step(100000);
  EXPECT_EQ(replay.index(), 599);
  replay.step(-1);
  EXPECT_EQ(replay.index(), 598);
  replay.goTo(590);
  replay.play();
  EXPECT_TRUE(replay.isPlaying());
  ASSERT_TRUE(fixtures::waitFor([&] { return !replay.isPlaying(); })) << "it ends at the last frame";
  EXPECT_EQ(replay.index(), 599);
  EXPECT_THAT(replay.picturesWords().toStdString(), HasSubstr("no pictures were kept"));
  EXPECT_EQ(replay.pulses().size(), 40u);
  const auto track = folder_.path() / "track";  // as `facenav track` writes it: no guidance, no pulses
  fs::create_directories(track);
  fs::copy(first_ / "poses.csv", track / "poses.csv");
  replay.openFolder(QString::fromStdString(track.string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return replay.isOpen(); }));
  EXPECT_TRUE(replay.pulses().empty());
  EXPECT_EQ(replay.figures(), "") << "without guidance.csv there is no figure";
}

TEST_F(ReviewTest, ComparisonStatesTheReturnErrorOfTheTwoSessions) {
  ReviewPresenter review(model_);
  review.refresh();
  waitForSession(review);
  const auto comparison = review.compareWith(QString::fromStdString(first_.filename().string()));
  ASSERT_TRUE(comparison && comparison->targets.size() == 1);
  // 1.5 mm by construction, plus the uncertainty of 38 pulses with a spread of 1.2 mm: 1.2 * sqrt(2 / 38) =
  // 0.28 mm a side.
  EXPECT_NEAR(comparison->targets[0].distance_mm, 1.5, 0.8);
  EXPECT_NEAR(comparison->targets[0].angle_deg, 0.0, 1e-4);
}

TEST_F(ReviewTest, TheReportNamesNobodyUnlessAskedInHtmlPdfAndCsv) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  ReviewPresenter review(model_);
  review.refresh();
  waitForSession(review);
  review.makeReport(false);
  const auto wordsOf = [&](const char* name) { return readWholeFile(second_ / name); };
  const std::string pdf = fixtures::wordsOfPdf(wordsOf("report.pdf"));
  EXPECT_THAT(pdf, HasSubstr("TMSsessionreport")) << "the PDF's words can be read";
  EXPECT_THAT(pdf, HasSubstr("figure-870mm"));
  EXPECT_THAT(pdf, HasSubstr(model_.current().id.toStdString()));
  EXPECT_THAT(wordsOf("report.html"), HasSubstr("figure-8 70 mm"));
  EXPECT_THAT(wordsOf("report.html"), HasSubstr("data:image/png;base64,")) << "pulses on the cortex";
  EXPECT_THAT(wordsOf("report.html"), HasSubstr("Map of the MEPs"));
  for (const char* file : {"report.html", "report.pdf", "pulses.csv"}) {
    EXPECT_THAT(wordsOf(file), Not(HasSubstr("Quixley"))) << file;
    EXPECT_THAT(wordsOf(file), Not(HasSubstr(folder_.path().filename().string()))) << file;
  }
  EXPECT_THAT(pdf, Not(HasSubstr("Quixley")));
  const std::string bytes = wordsOf("report.pdf");
  int pages = 0;
  for (std::size_t at = 0; (at = bytes.find("/Type /Page\n", at)) != std::string::npos; ++at) ++pages;
  EXPECT_GE(pages, 2);
  EXPECT_LE(pages, 3) << "two to three pages";
  if (const char* folder = std::getenv("FACENAV_GUI_PICTURES"))
    fs::copy_file(second_ / "report.pdf", fs::path(folder) / "report.pdf",
                  fs::copy_options::overwrite_existing);
  review.makeReport(true);
  EXPECT_THAT(fixtures::wordsOfPdf(wordsOf("report.pdf")), HasSubstr("JaneQuixley"));
  EXPECT_THAT(wordsOf("report.html"), HasSubstr("Jane Quixley"));
}

TEST_F(ReviewTest, TheWindowShowsPulsesReplayAndComparison) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window{Services{}};
  window.resize(1366, 768);
  window.show();
  window.openCase(QString::fromStdString((folder_.path() / "case").string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }));
  window.setWorkspace(Workspace::review);
  waitForSession(window.review());
  auto* page = window.findChild<ReviewWorkspace*>();
  ASSERT_TRUE(page);
  const auto pictureOf = [&] {
    fixtures::waitFor([] { return false; }, 300);
    return page->grab().toImage();
  };
  const QImage pulses = pictureOf();
  window.review().setColumn(report::PulseColumn::mep);
  EXPECT_NE(pulses, pictureOf()) << "other colours and charts";
  for (auto* heat : page->findChildren<QCheckBox*>())
    if (heat->text() == "MEP map") heat->click();
  EXPECT_NE(pulses, pictureOf());
  page->setPage(ReviewPage::replay);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.replay().isOpen(); }));
  window.replay().goTo(10);
  auto* scene = [&] {
    for (auto* view : page->findChildren<SceneView*>())
      if (view->isVisible()) return view;
    return static_cast<SceneView*>(nullptr);
  }();
  ASSERT_TRUE(scene);
  EXPECT_TRUE(scene->scene().showsCoil());
  window.replay().goTo(230);
  EXPECT_FALSE(scene->scene().showsCoil()) << "lost is shown as lost";
  page->setPage(ReviewPage::compare);
  fixtures::waitFor([] { return false; }, 200);
  int figures = 0;
  for (auto* table : page->findChildren<QTableWidget*>())
    if (table->isVisible() && table->horizontalHeaderItem(1)->text() == "figure") figures = table->rowCount();
  EXPECT_GE(figures, 7);
}

}  // namespace
}  // namespace facenav::ui
