// Files of other programs in the window, without a window: what would come in, what the answers change, one
// step of the plan, and the words.

#include "plan/import_presenter.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSettings>

#include "facenav/casefile/kept_session.h"
#include "facenav/dicom/series.h"
#include "gui_fixtures.h"
#include "plan/export_presenter.h"
#include "plan/other_words.h"
#include "support/coil_positions.h"

namespace facenav::ui {
namespace {

class Imports : public ::testing::Test {
 protected:
  Imports() : plan_(model_), import_(model_, plan_) {
    model_.open(fixtures::loadBallCase(folder_.path()));
    QObject::connect(&import_, &ImportPresenter::refused, [this](const QString& words) { refusal_ = words; });
    QObject::connect(&import_, &ImportPresenter::broughtIn,
                     [this](const QString& words, bool, const QString& session) {
                       said_ = words;
                       session_ = session;
                     });
  }
  QString write(const std::string& name, const std::string& content) const {
    return QString::fromStdString(testing::writtenFile(folder_.path() / name, content).string());
  }
  void open(const QStringList& files) {
    import_.open(files);
    settle();
  }
  void settle() {
    ASSERT_TRUE(fixtures::waitFor([this] { return !import_.isReading(); }));
  }
  std::size_t stored() const { return model_.current().store.targets().targets.size(); }
  const steps::PreviewedItem& item(int i) const { return import_.files()[0].preview.items[std::size_t(i)]; }

  testing::TemporaryFolder folder_;
  CaseModel model_;
  PlanPresenter plan_;
  ImportPresenter import_;
  QString refusal_, said_, session_;
};

TEST_F(Imports, NothingIsWrittenBeforeBringInAndOneUndoTakesAllTargetsBack) {
  plan_.addTarget(Point<Mri>(-40, 5, 60));
  open(
      {write("a.csv", testing::coilPosition("M1", {-1, 0, 1}) + testing::coilPosition("far", {0, 0, 1}, 900)),
       write("b.csv", testing::coilPosition("SMA", {0, 1, 2})),
       write("p.csv", testing::twoSessionsOfPulses())});
  EXPECT_EQ(import_.summary(), "2 targets and 3 pulses come in; 1 refused");
  EXPECT_EQ(fateWords(item(1)), "refused: its centre lies 900 mm from the middle of the head");
  EXPECT_EQ(stored(), 1u);
  EXPECT_FALSE(std::filesystem::exists(model_.current().store.folder() / "sessions"));
  import_.bringIn();
  EXPECT_EQ(stored(), 3u);
  EXPECT_EQ(plan_.activeName(), "M1");
  EXPECT_TRUE(said_.startsWith("2 targets came in")) << said_.toStdString();
  EXPECT_TRUE(said_.endsWith("with 3 pulses")) << said_.toStdString();
  EXPECT_EQ(casefile::sessionFolders(model_.current().store.folder()).size(), 2u);
  EXPECT_FALSE(session_.isEmpty());
  plan_.undo();
  EXPECT_EQ(stored(), 1u);
  EXPECT_EQ(plan_.activeName(), "Target 1");
  plan_.redo();
  EXPECT_EQ(stored(), 3u);
}

TEST_F(Imports, OnlyWhatIsTickedComesIn) {
  open({write("a.csv", testing::coilPosition("M1", {-1, 0, 1}) + testing::coilPosition("SMA", {0, 1, 2})),
        write("p.csv", testing::twoSessionsOfPulses())});
  import_.setTargetTaken(0, "M1", false);
  import_.setSessionTaken(1, "first", false);
  settle();
  EXPECT_EQ(import_.targets(), 1);
  EXPECT_EQ(import_.pulses(), 1);
  EXPECT_EQ(fateWords(item(0)), "stays out");
  import_.takeAll(false);
  settle();
  EXPECT_EQ(import_.summary(), "nothing comes in");
  import_.bringIn();
  EXPECT_EQ(stored(), 0u);
  import_.takeAll(true);
  settle();
  EXPECT_EQ(import_.summary(), "2 targets and 3 pulses come in");
}

TEST_F(Imports, AnAnswerIsAskedForByTheWindowsOwnWordsAndChangesWhatComesIn) {
  open({write(
      "a.mrk.json",
      R"({"markups": [{"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": [)"
      R"({"label": "M1", "position": [65, 0, 65], "orientation": [0.7071067811865475, 0, -0.7071067811865475,)"
      R"( 0, 1, 0, 0.7071067811865475, 0, 0.7071067811865475]}]}]})")});
  ASSERT_EQ(import_.files()[0].failure, "");
  EXPECT_EQ(assumedWords(import_.files()[0], "sform"),
            "Coordinates: LPS, as the file says; T1: the case's own, by its sform");
  ASSERT_TRUE(item(0).item.mri_T_coil);
  EXPECT_NEAR(item(0).item.mri_T_coil->translation_mm().x(), -65, 1e-6);
  const Eigen::Vector3d handle = item(0).item.mri_T_coil->rotation().col(1);
  auto order = import_.order(0);
  order.answers.flips_handle = true;
  import_.setOrder(0, order);
  settle();
  EXPECT_NEAR(item(0).item.mri_T_coil->rotation().col(1).dot(handle), -1, 1e-9);
  EXPECT_FALSE(import_.hasTwoForms(0)) << "the ball's forms agree";
}

TEST_F(Imports, EqualNamesAreReplacedOnlyWhenAsked) {
  open({write("a.csv", testing::coilPosition("M1", {-1, 0, 1}))});
  import_.bringIn();
  open({write("b.csv", testing::coilPosition("M1", {1, 0, 1}))});
  EXPECT_EQ(fateWords(item(0)),
            "refused: the case has a target of this name with another pose: tick Replace, or rename it");
  auto order = import_.order(0);
  order.replaces = true;
  import_.setOrder(0, order);
  settle();
  EXPECT_EQ(fateWords(item(0)), "replaces the one here");
  plan_.lockActive(true);  // the plan changes beside the preview
  settle();
  EXPECT_TRUE(fateWords(item(0)).contains("locked")) << fateWords(item(0)).toStdString();
}

TEST_F(Imports, NoWordOfTheWindowNamesAnOptionOfTheCommandLine) {
  const char* const kWords[] = {
      "its coordinates are 'World', of which RAS or LPS is not certain: give --space lps or --space ras",
      "as RAS its poses lie 80 mm from the skin, as LPS 4 mm: say with --space ras or --space lps which it "
      "is",
      "it belongs to another T1: the corners lie up to 9 mm from the case's; name the T1 with --t1",
      "sform and qform of this T1 differed when the case was prepared: name that T1 with --t1, and its form "
      "with --form if the file says none",
      "the file does not say which it means: give --form sform or --form qform",
      "the times of its pulses name no zone: taken as UTC+0 (--utc-offset)",
      "the file exists already: choose another name, or --replace",
      "holds one target: choose one with --target NAME",
      "the case has 2 targets: name those to draw with --target",
      "the file does not say its rate: taken as 1 A/us, SimNIBS's default (--didt)",
      "an option of a later version: --later-option"};
  for (const char* words : kWords) EXPECT_FALSE(inWindowWords(words).contains("--")) << words;
  EXPECT_EQ(
      inWindowWords(kWords[0]),
      "its coordinates are 'World', of which RAS or LPS is not certain: choose RAS or LPS under Coordinates");
  for (const auto& format : interop::formats())
    EXPECT_FALSE(inWindowWords(format.words).contains("--")) << format.words;
}

TEST_F(Imports, AnExportSaysWhatItWroteAndReplacesNothingUnasked) {
  open({write("a.csv", testing::coilPosition("M1", {-1, 0, 1}) + testing::coilPosition("SMA", {0, 1, 2}))});
  import_.bringIn();
  model_.setLabel("Family, Given");
  ExportPresenter exports(model_);
  QString refusal;
  QObject::connect(&exports, &ExportPresenter::refused, [&](const QString& words) { refusal = words; });
  EXPECT_EQ(exports.targets(), (QStringList{"M1", "SMA"}));
  for (const auto* format : exports.formats())
    EXPECT_FALSE(exports.usualFile(*format).contains("Family")) << format->name;
  steps::OtherExport order;
  order.format = "brainsight";
  order.targets = {"SMA"};
  order.output = folder_.path() / "out.txt";
  EXPECT_TRUE(exports.write(order).startsWith("Written: 1 target in ")) << refusal.toStdString();
  EXPECT_TRUE(exports.write(order).isEmpty());
  EXPECT_TRUE(refusal.contains("exists already")) << refusal.toStdString();
  EXPECT_FALSE(refusal.contains("--"));
  open({QString::fromStdString(order.output.string())});
  EXPECT_EQ(import_.summary(), "nothing comes in; 1 here already");
}

TEST_F(Imports, PlanAndReportAreWrittenForTheArchiveAndSent) {
  open({write("a.csv", testing::coilPosition("M1", {-1, 0, 1})),
        write("p.csv", testing::twoSessionsOfPulses())});
  import_.bringIn();
  dicom::writeSeries(*model_.current().mri, folder_.path() / "source", {});
  std::vector<std::filesystem::path> sent;
  ExportPresenter exports(model_, [&](const auto& node, const auto& path, auto&) {
    EXPECT_EQ(node.host, "pacs.example");
    sent.push_back(path);
    return 1;
  });
  QSettings().clear();
  EXPECT_EQ(exports.archiveWords(), "") << "none is set up";
  QSettings().setValue("archive/host", "pacs.example");
  QSettings().setValue("archive/title", "ARCHIVE");
  EXPECT_EQ(exports.archiveWords(), "ARCHIVE at pacs.example");
  QString refusal, written;
  QObject::connect(&exports, &ExportPresenter::refused, [&](const QString& words) { refusal = words; });
  QObject::connect(&exports, &ExportPresenter::written, [&](const QString& words) { written = words; });
  const auto run = [&](const DicomWish& wish) {
    refusal.clear();
    written.clear();
    exports.writeDicom(wish);
    fixtures::waitFor([&] { return !exports.isWriting() && !(refusal + written).isEmpty(); });
  };
  const auto wish = [&](DicomKind kind, const char* name) {
    return DicomWish{kind, {{"M1"}, folder_.path() / "source", folder_.path() / name}, exports.sessions()[0]};
  };
  run(wish(DicomKind::series, "plan"));
  EXPECT_TRUE(written.contains("images with the patient's name")) << refusal.toStdString();
  EXPECT_TRUE(sent.empty()) << "nothing is sent unasked";
  auto segments = wish(DicomKind::segments, "plan.dcm");
  segments.is_sent = true;
  run(segments);
  EXPECT_TRUE(written.endsWith("Sent: 1 files")) << refusal.toStdString();
  EXPECT_EQ(sent, std::vector{folder_.path() / "plan.dcm"});
  run(segments);
  EXPECT_TRUE(refusal.contains("exists already") && !refusal.contains("--")) << refusal.toStdString();
  run(wish(DicomKind::report, "report.dcm"));
  EXPECT_TRUE(written.startsWith("Written: the report")) << refusal.toStdString();
  auto elsewhere = wish(DicomKind::segments, "other.dcm");
  elsewhere.order.source = folder_.path() / "case";
  run(elsewhere);
  EXPECT_FALSE(refusal.isEmpty());
  QSettings().clear();
}

}  // namespace
}  // namespace facenav::ui
