#include "prepare/archive_presenter.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <fstream>

#include "facenav/core/error.h"
#include "gui_fixtures.h"

namespace facenav::ui {
namespace {

/// An archive with two series, used only through the presenter.
class ArchiveTest : public ::testing::Test {
 protected:
  ArchiveTest() {
    services_.callArchive = [this](const pacs::PacsNode& node) {
      if (node.title != "ORTHANC")
        throw Error("the archive does not know the title", node.title, "ask who runs it");
      ++calls_;
    };
    services_.findInArchive = [this](const pacs::PacsNode&, const pacs::PacsQuery& query, TaskMonitor&) {
      asked_ = query;
      pacs::PacsSeries t1, t2;
      t1.series_uid = "1.2", t1.study_uid = "1", t1.description = "T1", t1.images = 3;
      t2.series_uid = "1.3", t2.study_uid = "1", t2.description = "T2", t2.patient_name = "DOE^JANE";
      return std::vector<pacs::PacsSeries>{t1, t2};
    };
    services_.fetchFromArchive = [this](const pacs::PacsNode&, const pacs::PacsSeries& series,
                                        const std::filesystem::path& folder, pacs::Retrieval how,
                                        TaskMonitor& monitor) {
      for (int i = 0; holds_on_ && i < 500; ++i) {
        monitor.report("image", 0.1);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      std::filesystem::create_directories(folder);
      std::ofstream(folder / "1.dcm") << series.series_uid;
      how_ = how;
      return pacs::Received{3, pacs::Retrieval::get};
    };
    services_.listSeries = [](const std::filesystem::path&, TaskMonitor&) -> std::vector<dicom::SeriesInfo> {
      throw Error("no DICOM image in the folder", {}, "choose another");
    };
  }
  void settle() {
    fixtures::waitFor([&] { return !archive_.isBusy(); });
  }
  testing::TemporaryFolder folder_;
  Services services_;
  PrepareQueue queue_{services_};
  ArchivePresenter archive_{services_, queue_};
  pacs::PacsQuery asked_;
  std::optional<pacs::Retrieval> how_;
  std::atomic<bool> holds_on_{false};
  int calls_ = 0;
};

TEST_F(ArchiveTest, TheTestSaysWhetherTheArchiveKnowsUs) {
  auto node = archive_.node();
  node.title = "OTHER";
  archive_.setNode(node);
  archive_.test();
  EXPECT_TRUE(archive_.isBusy());
  settle();
  EXPECT_TRUE(archive_.isFault());
  EXPECT_TRUE(archive_.words().contains("OTHER"));
  node.title = "ORTHANC";
  archive_.setNode(node);
  archive_.test();
  settle();
  EXPECT_FALSE(archive_.isFault());
  EXPECT_EQ(calls_, 1);
}

TEST_F(ArchiveTest, TheConnectionIsRememberedAndAQueryIsNot) {
  auto node = archive_.node();
  node.host = "pacs.hospital", node.port = 4242, node.title = "ORTHANC";
  node.tls = pacs::Tls{"/etc/trust.pem", "", ""};
  archive_.setNode(node);
  archive_.setRetrieval(pacs::Retrieval::move);
  pacs::PacsQuery query;
  query.patient_id = "Q-77-SECRET";
  archive_.find(query);
  settle();
  EXPECT_EQ(asked_.patient_id, "Q-77-SECRET");
  const ArchivePresenter again(services_, queue_);
  EXPECT_EQ(again.node().host, "pacs.hospital");
  EXPECT_EQ(again.node().port, 4242);
  ASSERT_TRUE(again.node().tls);
  EXPECT_EQ(again.node().tls->trusted_certificate, "/etc/trust.pem");
  EXPECT_EQ(again.retrieval(), pacs::Retrieval::move);
  QSettings settings;
  for (const auto& key : settings.allKeys())
    EXPECT_FALSE(settings.value(key).toString().contains("SECRET")) << key.toStdString();
  archive_.setNode({});
  archive_.setRetrieval(pacs::Retrieval::automatic);
}

TEST_F(ArchiveTest, AFetchedSeriesIsQueuedInAPrivateFolderThatGoesWithItsJob) {
  archive_.find({});
  settle();
  ASSERT_EQ(archive_.series().size(), 2u);
  archive_.fetch(1);
  settle();
  ASSERT_EQ(queue_.jobs().size(), 1u);
  const auto job = queue_.jobs().front();
  EXPECT_TRUE(QFileInfo(job.input + "/1.dcm").exists());
  EXPECT_FALSE(job.title.contains("DOE"));
  EXPECT_FALSE(QFileInfo(receivedFolder()).permissions() & (QFile::ReadGroup | QFile::ReadOther));
  EXPECT_EQ(how_, pacs::Retrieval::automatic);
  queue_.remove(job.id);
  EXPECT_FALSE(QFileInfo::exists(job.input));
}

TEST_F(ArchiveTest, ACancelledFetchQueuesNothing) {
  archive_.find({});
  settle();
  holds_on_ = true;
  archive_.fetch(0);
  ASSERT_TRUE(fixtures::waitFor([&] { return archive_.words().contains("image"); }));
  archive_.cancel();
  settle();
  EXPECT_TRUE(queue_.jobs().empty());
  EXPECT_TRUE(archive_.words().contains("cancelled"));
}

TEST_F(ArchiveTest, WhatWasFetchedForAJobThatIsNoMoreIsRemovedAtTheNextStart) {
  const QString left_over = receivedFolder() + "/left_over";
  QDir().mkpath(left_over);
  queue_.restore();
  EXPECT_FALSE(QFileInfo::exists(left_over));
}

TEST_F(ArchiveTest, ASecondWindowLeavesAloneWhatTheFirstHasFetched) {
  queue_.restore();
  const QString first_ones = receivedFolder() + "/first_ones";
  QDir().mkpath(first_ones);
  {
    PrepareQueue second(services_);
    second.restore();
  }
  EXPECT_TRUE(QFileInfo::exists(first_ones));
  QDir(first_ones).removeRecursively();
}

}  // namespace
}  // namespace facenav::ui
