// PACS client against a real archive: stored images are found and retrieved unchanged, by C-GET and by
// C-MOVE.

#include "facenav/pacs/pacs.h"

#include <gmock/gmock.h>

#include "../dicom/dicom_bytes.h"
#include "facenav/dicom/derived_objects.h"
#include "facenav/dicom/import_volume.h"
#include "support/orthanc.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// One archive for all tests, with one synthetic series of ten slices.
class Pacs : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (orthancProgram().empty()) return;
    archive_ = std::make_unique<Orthanc>();
    series_ = std::make_unique<TemporaryFolder>();
    writeSlices(series_->path() / "in", makeSlices(10));
    is_up_ = archive_->answers(archive_->node());
    TaskMonitor monitor;
    if (is_up_) sent_ = pacs::store(archive_->node(), series_->path() / "in", monitor);
  }
  static void TearDownTestSuite() {
    archive_.reset();
    series_.reset();
  }
  void SetUp() override {
    FACENAV_NEEDS_ORTHANC();
    ASSERT_TRUE(is_up_) << "Orthanc did not start";
    ASSERT_EQ(sent_, 10);
  }
  static pacs::PacsNode node() { return archive_->node(); }
  static fs::path original() { return series_->path() / "in"; }

  void expectSameSeries(const fs::path& folder) const {
    TaskMonitor monitor;
    const auto received = dicom::importVolume(folder, std::nullopt, monitor).volume;
    const auto sent = dicom::importVolume(original(), std::nullopt, monitor).volume;
    EXPECT_EQ(received.voxels, sent.voxels);
    EXPECT_TRUE(received.grid.matches(sent.grid));
    for (const auto& entry : fs::directory_iterator(folder))
      EXPECT_EQ(entry.status().permissions() & fs::perms::all,
                fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(fs::status(folder).permissions() & fs::perms::all, fs::perms::owner_all);
  }

  TemporaryFolder folder_;
  TaskMonitor monitor_;

 private:
  static inline std::unique_ptr<Orthanc> archive_;
  static inline std::unique_ptr<TemporaryFolder> series_;
  static inline bool is_up_ = false;
  static inline int sent_ = 0;
};

TEST_F(Pacs, FindsTheSeriesByPatient) {
  pacs::PacsQuery query;
  query.patient_id = "id";
  const auto found = pacs::findSeries(node(), query, monitor_);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].study_uid, "1.2.3");
  EXPECT_EQ(found[0].series_uid, "1.2.3.4");
  EXPECT_EQ(found[0].description, "t1_mprage");
  EXPECT_EQ(found[0].modality, "MR");
  EXPECT_EQ(found[0].date, "2020-01-02");
  EXPECT_EQ(found[0].images, 10);
  query.patient_id = "nobody";
  EXPECT_TRUE(pacs::findSeries(node(), query, monitor_).empty());
  query.patient_id = "id";
  query.modality = "CT";
  EXPECT_TRUE(pacs::findSeries(node(), query, monitor_).empty());
}

TEST_F(Pacs, EmptySearchIsRefused) { EXPECT_THROW(pacs::findSeries(node(), {}, monitor_), Error); }

TEST_F(Pacs, GetBringsTheSameSeries) {
  const auto received =
      pacs::retrieve(node(), "1.2.3", "1.2.3.4", folder_.path() / "got", pacs::Retrieval::get, monitor_);
  EXPECT_EQ(received.images, 10);
  expectSameSeries(folder_.path() / "got");
}

TEST_F(Pacs, MoveBringsTheSameSeriesToOurOwnProvider) {
  const auto received =
      pacs::retrieve(node(), "1.2.3", "1.2.3.4", folder_.path() / "moved", pacs::Retrieval::move, monitor_);
  EXPECT_EQ(received.images, 10);
  EXPECT_EQ(received.how, pacs::Retrieval::move);
  expectSameSeries(folder_.path() / "moved");
}

TEST_F(Pacs, AbsentSeriesLeavesNothingBehind) {
  for (const auto how : {pacs::Retrieval::get, pacs::Retrieval::move})
    EXPECT_THROW(pacs::retrieve(node(), "1.2.3", "1.2.3.99", folder_.path() / "none", how, monitor_), Error);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(Pacs, OnlyAnEmptyFolderIsReceivedInto) {
  writeBytes(folder_.path() / "full/a", "x");
  EXPECT_THROW(
      pacs::retrieve(node(), "1.2.3", "1.2.3.4", folder_.path() / "full", pacs::Retrieval::get, monitor_),
      Error);
  EXPECT_THROW(pacs::retrieve(node(), "1.2.3", "../1", folder_.path() / "x", pacs::Retrieval::get, monitor_),
               Error);
}

TEST_F(Pacs, CancelledRetrievalLeavesNothingBehind) {
  monitor_.cancel();
  EXPECT_THROW(
      pacs::retrieve(node(), "1.2.3", "1.2.3.4", folder_.path() / "got", pacs::Retrieval::get, monitor_),
      Cancelled);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(Pacs, WrongTitleIsSaid) {
  auto wrong = node();
  wrong.title = "OTHER";
  try {
    pacs::echo(wrong);
    FAIL() << "an archive of another title answered";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("refuses us"));
  }
}

TEST_F(Pacs, UnknownDestinationOfAMoveIsSaid) {
  auto stranger = node();
  stranger.own_title = "STRANGER";
  EXPECT_THROW(
      pacs::retrieve(stranger, "1.2.3", "1.2.3.4", folder_.path() / "x", pacs::Retrieval::move, monitor_),
      Error);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(Pacs, OnlyDicomIsSent) {
  writeBytes(folder_.path() / "a.txt", "no DICOM");
  EXPECT_THROW(pacs::store(node(), folder_.path(), monitor_), Error);
}

TEST_F(Pacs, WhatIsMadeFromASeriesIsFiledBesideIt) {
  Slice first;
  first.patient_id = "plan";
  first.study_uid = "1.2.9", first.series_uid = "1.2.9.1";
  const auto in = folder_.path() / "in", out = folder_.path() / "out";
  writeSlices(in, makeSlices(10, first));
  const auto source = dicom::listSeries(in, monitor_).at(0);
  dicom::writeDerivedSeries(source, dicom::loadSeries(source, monitor_), {"plan", "drawn", 0, 4000}, out,
                            false, monitor_);
  dicom::writeEncapsulatedPdf(source, "%PDF-1.4\n", "report", out / "report.dcm");
  EXPECT_EQ(pacs::store(node(), in, monitor_), 10);
  EXPECT_EQ(pacs::store(node(), out, monitor_), 11);
  pacs::PacsQuery query;
  query.patient_id = "plan";
  query.modality = "";
  std::map<std::string, int> images;
  for (const auto& series : pacs::findSeries(node(), query, monitor_)) {
    EXPECT_EQ(series.study_uid, "1.2.9");
    images[series.modality + " " + series.description] = series.images;
  }
  EXPECT_EQ(images, (std::map<std::string, int>{{"MR t1_mprage", 10}, {"MR plan", 10}, {"DOC report", 1}}));
}

TEST(PacsWithoutArchive, NobodyAnswers) {
  pacs::PacsNode nobody;
  nobody.port = freePort();
  try {
    pacs::echo(nobody);
    FAIL() << "somebody answered";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("does not answer"));
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(PacsWithoutArchive, ImpossibleSettingsAreRefused) {
  for (const auto& change : std::vector<std::function<void(pacs::PacsNode&)>>{
           [](auto& n) { n.port = 0; }, [](auto& n) { n.title = ""; },
           [](auto& n) { n.title = "SEVENTEEN_LETTERS"; }, [](auto& n) { n.own_title = "A\\B"; },
           [](auto& n) { n.host = ""; },
           [](auto& n) {
             n.tls = pacs::Tls{"/none.pem", {}, {}};
           }}) {
    pacs::PacsNode node;
    change(node);
    EXPECT_THROW(pacs::echo(node), Error);
  }
}

TEST(PacsTls, EncryptedAndOnlyWithATrustedCertificate) {
  FACENAV_NEEDS_ORTHANC();
  const TemporaryFolder folder;
  const std::string make =
      "cd '" + folder.path().string() +
      "' && for n in archive other; do openssl req -x509 -newkey rsa:2048 -nodes -keyout $n.key "
      "-out $n.pem -days 2 -subj /CN=127.0.0.1 >/dev/null 2>&1 || exit 1; done";
  if (std::system(make.c_str()) != 0) GTEST_SKIP() << "program not installed: openssl";
  const auto at = [&](const char* name) { return (folder.path() / name).string(); };
  const Orthanc archive(
      "\"DicomTlsEnabled\": true, \"DicomTlsRemoteCertificateRequired\": false, \"DicomTlsCertificate\": \"" +
      at("archive.pem") + "\", \"DicomTlsPrivateKey\": \"" + at("archive.key") +
      "\", \"DicomTlsTrustedCertificates\": \"" + at("archive.pem") + "\", ");
  auto trusted = archive.node();
  trusted.tls = pacs::Tls{at("archive.pem"), {}, {}};
  ASSERT_TRUE(archive.answers(trusted));
  auto other = archive.node();
  other.tls = pacs::Tls{at("other.pem"), {}, {}};
  EXPECT_THROW(pacs::echo(other), Error);
  EXPECT_THROW(pacs::echo(archive.node()), Error);  // without TLS
}

}  // namespace
}  // namespace facenav::testing
