#include "prepare/prepare_queue.h"

#include <gmock/gmock.h>

#include <QSettings>
#include <atomic>
#include <fstream>

#include "facenav/core/error.h"
#include "facenav/volume/nifti.h"
#include "gui_fixtures.h"

namespace facenav::ui {
namespace {

namespace fs = std::filesystem;

dicom::SeriesInfo series(const std::string& uid, bool is_recommended) {
  dicom::SeriesInfo info;
  info.series_uid = info.id = uid;
  info.description = "T1 " + uid;
  info.is_loadable = true;
  info.is_recommended = is_recommended;
  return info;
}

/// Services that make ball cases and record how they are called.
class PrepareQueueTest : public ::testing::Test {
 protected:
  PrepareQueueTest() : cases_(folder_.path() / "cases") {
    QSettings().clear();
    services_.listSeries = [this](const fs::path&, TaskMonitor&) { return series_; };
    services_.prepareCase = [this](const PrepareOrder& order, TaskMonitor& monitor) {
      at_once_ = std::max<int>(at_once_, ++running_);
      chosen_.push_back(order.series_uid.value_or(""));
      labelled_.push_back(order.is_labelled_by_patient);
      const bool fails = fails_ > 0 && fails_-- > 0;
      for (int i = 0; i < 10 || blocks_; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        if (monitor.isCancelled()) --running_;
        monitor.report("modelling", 0.1 * (i % 10));
      }
      --running_;
      if (fails) throw Error("no head in this volume");
      casefile::CaseStore::create(order.case_folder, fixtures::ballCase(), {}, false);
    };
    queue_ = std::make_unique<PrepareQueue>(services_);
    queue_->setCasesFolder(QString::fromStdString(cases_.string()));
  }
  int add(const std::string& name) {
    fs::create_directories(folder_.path() / name);
    return queue_->add(QString::fromStdString((folder_.path() / name).string()));
  }
  bool waitUntilIdle() {
    return fixtures::waitFor([this] {
      for (const auto& job : queue_->jobs())
        if (job.state == JobState::queued || job.state == JobState::preparing) return false;
      return !queue_->isRunning();
    });
  }
  std::vector<std::string> caseFolders() const {
    std::vector<std::string> names;
    for (const auto& item : fs::directory_iterator(cases_)) names.push_back(item.path().filename().string());
    return names;
  }

  testing::TemporaryFolder folder_;
  fs::path cases_;
  Services services_;
  std::vector<dicom::SeriesInfo> series_{series("other", false), series("best", true)};
  std::atomic<int> running_{0}, at_once_{0}, fails_{0};
  std::atomic<bool> blocks_{false};
  std::vector<std::string> chosen_;
  std::vector<bool> labelled_;
  std::unique_ptr<PrepareQueue> queue_;
};

TEST_F(PrepareQueueTest, TheFieldIsBuiltAfterAllCasesAndNeverDuringATreatment) {
  std::vector<std::string> built;
  services_.buildField = [&](const fs::path& folder, TaskMonitor&) {
    EXPECT_TRUE(fs::exists(folder / "case.json"));
    EXPECT_EQ(running_, 0);
    built.push_back(folder.filename().string());
  };
  queue_->setHeld(true);
  add("a");
  add("b");
  queue_->setHeld(false);
  EXPECT_TRUE(fixtures::waitFor([&] { return built.size() == 2; }));
  EXPECT_TRUE(waitUntilIdle());
  add("c");
  EXPECT_TRUE(fixtures::waitFor([&] { return built.size() == 3; }));
}

TEST_F(PrepareQueueTest, SeveralDropsArePreparedOneAtATimeFromTheirRecommendedSeries) {
  add("a");
  add("b");
  add("c");
  EXPECT_EQ(add("c"), 3);  // the same input is queued only once
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_TRUE(queue_->jobs().empty());
  EXPECT_EQ(at_once_, 1);
  EXPECT_EQ(chosen_, (std::vector<std::string>{"best", "best", "best"}));
  EXPECT_EQ(caseFolders().size(), 3u);
  for (const auto& name : caseFolders())  // pseudonymous: the case's random id, not the input's name
    EXPECT_EQ(name, casefile::CaseStore::open(cases_ / name).caseId());
}

TEST_F(PrepareQueueTest, AFailureStaysWithItsLineTheNextGoesOnAndItCanBeTriedAgain) {
  fails_ = 1;
  const int first = add("a");
  add("b");
  ASSERT_TRUE(waitUntilIdle());
  ASSERT_EQ(queue_->jobs().size(), 1u);
  EXPECT_EQ(queue_->job(first)->state, JobState::failed);
  EXPECT_TRUE(queue_->job(first)->failure.contains("no head in this volume"));
  EXPECT_EQ(caseFolders().size(), 1u);
  queue_->retry(first);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_TRUE(queue_->jobs().empty());
  EXPECT_EQ(caseFolders().size(), 2u);
}

TEST_F(PrepareQueueTest, WithoutARecommendedSeriesItAsksAndTakesTheOneChosen) {
  series_ = {series("one", false), series("two", false)};
  int asked = 0;
  QObject::connect(queue_.get(), &PrepareQueue::choiceNeeded, [&](int id) { asked = id; });
  const int id = add("a");
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_EQ(asked, id);
  EXPECT_EQ(queue_->job(id)->state, JobState::needs_choice);
  EXPECT_FALSE(fs::exists(cases_) && !caseFolders().empty());
  queue_->add(queue_->job(id)->input, "two");
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_EQ(chosen_, std::vector<std::string>{"two"});
  EXPECT_TRUE(queue_->jobs().empty());
}

TEST_F(PrepareQueueTest, OfSeveralPatientsItAsksWhose) {
  series_ = {series("one", false), series("two", false)};
  for (int i = 0; i < 2; ++i) series_[std::size_t(i)].patient = i + 1, series_[std::size_t(i)].rows = 256;
  const int id = add("a");
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_EQ(queue_->job(id)->state, JobState::needs_choice);
  EXPECT_EQ(choiceWords(*queue_->job(id)), "images of 2 patients");
  EXPECT_TRUE(chosen_.empty());
}

TEST_F(PrepareQueueTest, OfSeveralReadingsItAsksWhich) {
  series_ = {series("one", false), series("one#2", false)};
  for (auto& info : series_) info.joined.emplace().readings = 2;
  const int id = add("a");
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_EQ(queue_->job(id)->state, JobState::needs_choice);
  EXPECT_EQ(choiceWords(*queue_->job(id)), "slices that can be read in several ways");
  EXPECT_TRUE(chosen_.empty());
}

TEST_F(PrepareQueueTest, CasesAreLabelledByPatientOnlyWhenAsked) {
  add("a");
  ASSERT_TRUE(waitUntilIdle());
  queue_->setLabelsByPatient(true);
  add("b");
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_EQ(labelled_, (std::vector<bool>{false, true}));
}

TEST_F(PrepareQueueTest, CancelLeavesNothingBehindAndTheNextBegins) {
  blocks_ = true;
  const int first = add("a"), second = add("b");
  ASSERT_TRUE(fixtures::waitFor([&] { return running_ == 1 && !queue_->job(first)->step.isEmpty(); }));
  EXPECT_EQ(queue_->job(second)->state, JobState::queued);
  queue_->cancel(first);
  ASSERT_TRUE(fixtures::waitFor([&] { return queue_->job(second)->state == JobState::preparing; }));
  EXPECT_EQ(queue_->job(first)->state, JobState::cancelled);
  EXPECT_TRUE(caseFolders().empty());
  queue_->cancel(second);
  ASSERT_TRUE(waitUntilIdle());
}

TEST_F(PrepareQueueTest, HeldNothingBeginsAndReleasedItDoes) {
  queue_->setHeld(true);
  const int id = add("a");
  fixtures::waitFor([] { return false; }, 40);
  EXPECT_EQ(queue_->job(id)->state, JobState::queued);
  queue_->setHeld(false);
  ASSERT_TRUE(waitUntilIdle());
  EXPECT_EQ(caseFolders().size(), 1u);
}

TEST_F(PrepareQueueTest, WhatWaitedWhenTheProgramEndedIsTakenUpAgain) {
  blocks_ = true;
  add("a");
  add("b");
  ASSERT_TRUE(fixtures::waitFor([&] { return running_ == 1; }));
  queue_.reset();
  blocks_ = false;
  running_ = 0;
  PrepareQueue next(services_);
  next.setCasesFolder(QString::fromStdString(cases_.string()));
  next.restore();
  EXPECT_EQ(next.jobs().size(), 2u);
  ASSERT_TRUE(fixtures::waitFor([&] { return next.jobs().empty(); }));
  EXPECT_EQ(caseFolders().size(), 2u);
}

TEST(PrepareInput, TakesTheKindsOfFileThatTheCommandLineTakes) {
  testing::TemporaryFolder folder;
  const auto make = [&](const char* name) {
    std::ofstream(folder.path() / name) << "x";
    return QString::fromStdString((folder.path() / name).string());
  };
  for (const auto& ending : volume::niftiEndings()) {
    const QString path = make(("t1" + ending).c_str());
    EXPECT_TRUE(isNifti(path)) << ending;
  }
  EXPECT_EQ(inputOf(make("one.nii.gz")), make("one.nii.gz"));
  const QString header = make("pair.hdr");
  EXPECT_EQ(inputOf(make("pair.img")), header);  // both files of a pair: one volume
  EXPECT_EQ(inputOf(header), header);
  EXPECT_EQ(inputOf(make("IM0001")), QString::fromStdString(folder.path().string()));
}

}  // namespace
}  // namespace facenav::ui
