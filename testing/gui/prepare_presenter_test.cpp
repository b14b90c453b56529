#include "prepare/prepare_presenter.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QListWidget>
#include <QSettings>
#include <cstdlib>

#include "gui_fixtures.h"
#include "prepare/series_page.h"

namespace facenav::ui {
namespace {

dicom::SeriesInfo seriesOf(int patient) {
  dicom::SeriesInfo info;
  info.series_uid = info.id = "1.2." + std::to_string(patient);
  info.description = "T1 MPRAGE";
  info.modality = "MR", info.plane = "sagittal", info.date = "2026-11-20";
  info.rows = info.columns = 256, info.slices = 176;
  info.spacing_mm = {1, 1, 1};
  info.is_loadable = info.is_fit_for_navigation = true;
  info.fitness = "fit for navigation";
  info.patient = patient;
  return info;
}

/// Lists the series of a folder.
class PreparePresenterTest : public ::testing::Test {
 protected:
  PreparePresenterTest() : queue_(services_), presenter_(services_, model_, tasks_, queue_) {
    QSettings().clear();
    queue_.setHeld(true);
    services_.listSeries = [this](const std::filesystem::path&, TaskMonitor&) { return series_; };
    services_.whoseSeries = [](const dicom::SeriesInfo& info) {
      return info.patient == 1 ? "Doe, Jane, born 1970-01-31, F, ID 4711" : "Roe, Rose, F, ID 4712";
    };
  }
  bool open() {
    presenter_.openInput("/somewhere");
    return fixtures::waitFor([this] { return !tasks_.isRunning() && !presenter_.lines().empty(); });
  }
  Services services_;
  std::vector<dicom::SeriesInfo> series_{seriesOf(1), seriesOf(2)};
  CaseModel model_;
  TaskRunner tasks_;
  PrepareQueue queue_;
  PreparePresenter presenter_;
};

TEST_F(PreparePresenterTest, OfSeveralPatientsNoneIsChosenAndNamesAreShownWhenAsked) {
  ASSERT_TRUE(open());
  EXPECT_EQ(presenter_.recommendedLine(), -1);
  EXPECT_EQ(presenter_.lines()[0].patient, "patient 1");
  EXPECT_EQ(presenter_.lines()[1].patient, "patient 2");
  presenter_.setPatientsShown(true);
  EXPECT_EQ(presenter_.lines()[1].patient, "Roe, Rose, F, ID 4712");
  presenter_.setPatientsShown(false);
  EXPECT_EQ(presenter_.lines()[1].patient, "patient 2");
}

TEST_F(PreparePresenterTest, OfOnePatientNothingIsSaidUnlessAsked) {
  series_ = {seriesOf(1)};
  series_[0].is_recommended = true;
  ASSERT_TRUE(open());
  EXPECT_EQ(presenter_.recommendedLine(), 0);
  EXPECT_EQ(presenter_.lines()[0].patient, "");
  presenter_.setPatientsShown(true);
  EXPECT_TRUE(presenter_.lines()[0].patient.startsWith("Doe, Jane"));
}

/// Readings of slices with UIDs of their own: as one scan or as two.
std::vector<dicom::SeriesInfo> readings() {
  std::vector<dicom::SeriesInfo> series{seriesOf(1), seriesOf(1), seriesOf(1)};
  dicom::JoinedSlices joined;
  joined.series_uid = "1.2.1";
  joined.series_uids = joined.frame_of_reference_uids = 352;
  joined.agreeing = {dicom::SliceTrait::patient, dicom::SliceTrait::series_number};
  joined.readings = 2;
  for (auto& info : series) info.joined = joined;
  series[0].part = "acquisition number 1";
  series[1].part = "acquisition number 2", series[1].id += "#2";
  series[2].part = "all slices", series[2].id += "#3", series[2].slices = 352;
  series[2].is_loadable = false;
  series[2].problem = "holds 2 volumes of the same place (4-D)";
  return series;
}

TEST_F(PreparePresenterTest, OfSeveralReadingsNoneIsChosen) {
  series_ = readings();
  SeriesPage page(presenter_);
  page.resize(900, 400);
  page.show();
  ASSERT_TRUE(open());
  EXPECT_EQ(presenter_.recommendedLine(), -1);
  EXPECT_TRUE(presenter_.lines()[0].title.contains("acquisition number 1"));
  EXPECT_TRUE(presenter_.lines()[0].detail.contains("one of 2 ways to read them: choose the right one"));
  EXPECT_EQ(page.findChild<QListWidget*>()->currentRow(), -1);
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
    page.grab().save(QString(pictures) + "/series_of_two_readings.png");
  presenter_.prepare(1);
  ASSERT_EQ(queue_.jobs().size(), 1u);
  EXPECT_EQ(queue_.jobs()[0].series_uid, "1.2.1#2");
}

TEST_F(PreparePresenterTest, JoinedSlicesAreSaidAndMayBeRecommended) {
  series_ = {readings()[0]};
  series_[0].joined->readings = 1;
  series_[0].is_recommended = true;
  ASSERT_TRUE(open());
  EXPECT_EQ(presenter_.recommendedLine(), 0);
  EXPECT_TRUE(presenter_.lines()[0].detail.contains("slices with 352 different series UIDs were joined"));
}

TEST_F(PreparePresenterTest, ThePageAsksWhichPatientBeforeItPreparesAnyone) {
  SeriesPage page(presenter_);
  page.resize(900, 400);
  page.show();
  ASSERT_TRUE(open());
  auto* list = page.findChild<QListWidget*>();
  QAbstractButton *prepare = nullptr, *patients = nullptr;
  for (auto* button : page.findChildren<QAbstractButton*>()) {
    if (button->text() == "Prepare the chosen series") prepare = button;
    if (button->text() == "show patients") patients = button;
  }
  ASSERT_TRUE(list && prepare && patients);
  EXPECT_EQ(list->currentRow(), -1);
  EXPECT_FALSE(prepare->isEnabled());
  patients->click();
  EXPECT_TRUE(list->item(1)->text().contains("Roe, Rose"));
  list->setCurrentRow(1);
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
    page.grab().save(QString(pictures) + "/series_of_two_patients.png");
  ASSERT_TRUE(prepare->isEnabled());
  prepare->click();
  ASSERT_EQ(queue_.jobs().size(), 1u);
  EXPECT_EQ(queue_.jobs()[0].series_uid, "1.2.2");
}

}  // namespace
}  // namespace facenav::ui
