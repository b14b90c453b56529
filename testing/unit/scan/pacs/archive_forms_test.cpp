// The forms of images that are offered to an archive, and what its refusals mean.

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "dimse_status.h"
#include "facenav/core/child_process.h"
#include "facenav/core/error.h"
#include "facenav/pacs/pacs.h"
#include "storage_classes.h"
#include "support/orthanc.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kJpeg2000 = "1.2.840.10008.1.2.4.90";

TEST(ArchiveForms, WhatTheArchiveHoldsIsOfferedFirst) {
  const auto sets = pacs::syntaxesToTry({kJpeg2000});
  EXPECT_EQ(sets[0], std::vector<std::string>{kJpeg2000});
  EXPECT_EQ(sets[1], pacs::imageSyntaxes());
  const auto unknown = pacs::syntaxesToTry({});
  EXPECT_EQ(unknown[0], pacs::imageSyntaxes());
  EXPECT_EQ(std::count(unknown.begin(), unknown.end(), std::vector<std::string>{kJpeg2000}), 1);
}

TEST(ArchiveForms, AStatusIsSaidInWords) {
  EXPECT_THAT(pacs::statusInWords(0xA702, "US").first, HasSubstr("could not send the images"));
  EXPECT_THAT(pacs::statusInWords(0xA700, "US").first, HasSubstr("out of resources (disk or memory)"));
  EXPECT_THAT(pacs::statusInWords(0xA801, "US").first, HasSubstr("'US'"));
  EXPECT_THAT(pacs::statusInWords(0xA900, "US").first, HasSubstr("do not match"));
  EXPECT_THAT(pacs::statusInWords(0xC000, "US").first, HasSubstr("could not process the request"));
  EXPECT_THAT(pacs::statusInWords(0xC123, "US").first, HasSubstr("could not process the request"));
  EXPECT_THAT(pacs::statusInWords(0x0124, "US").first, HasSubstr("does not allow 'US'"));
}

/// DCMTK's archive, which takes and sends JPEG 2000 and cannot decompress it.
class Jpeg2000Archive {
 public:
  Jpeg2000Archive() {
    node_.port = freePort();
    node_.own_port = freePort();
    node_.title = "QR";
    node_.timeout_s = 20;
    fs::create_directories(folder_.path() / "DB");
    const auto config = folder_.path() / "config";
    std::ofstream(config) << "NetworkTCPPort = " << node_.port
                          << "\nMaxPDUSize = 16384\nMaxAssociations = 8\n"
                          << "HostTable BEGIN\nus = (FACENAV, 127.0.0.1, " << node_.own_port
                          << ")\nHostTable END\nVendorTable BEGIN\nVendorTable END\nAETable BEGIN\nQR "
                          << (folder_.path() / "DB").string() << " RW (9, 64mb) ANY\nAETable END\n";
    ChildOptions options;
    options.output = ChildOptions::Output::nowhere;
    process_ = std::make_unique<ChildProcess>(
        ChildProcess::start({kProgram, "-c", config.string(), "+xv", "-xv"}, options));
  }
  ~Jpeg2000Archive() { process_->end(); }
  const pacs::PacsNode& node() const { return node_; }
  bool answers() const {
    for (int i = 0; i < 100; ++i) try {
        pacs::echo(node_);
        return true;
      } catch (const Error&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
      }
    return false;
  }
  static constexpr const char* kProgram = "/usr/bin/dcmqrscp";

 private:
  TemporaryFolder folder_;
  pacs::PacsNode node_;
  std::unique_ptr<ChildProcess> process_;
};

TEST(ArchiveForms, AnArchiveThatHoldsJpeg2000AloneSendsIt) {
  const fs::path image = sharedData() / "dicom_variety/pydicom/MR_small_jp2klossless.dcm";
  FACENAV_NEEDS(image);
  if (!fs::exists(Jpeg2000Archive::kProgram)) GTEST_SKIP() << "Debian package dcmtk is not installed";
  const Jpeg2000Archive archive;
  ASSERT_TRUE(archive.answers());
  TaskMonitor monitor;
  ASSERT_EQ(pacs::store(archive.node(), image, monitor), 1);
  pacs::PacsQuery query;
  query.study_date = "19000101-20991231";
  const auto found = pacs::findSeries(archive.node(), query, monitor);
  ASSERT_EQ(found.size(), 1u);
  const TemporaryFolder folder;
  for (const auto how : {pacs::Retrieval::get, pacs::Retrieval::move}) {
    const auto got = folder.path() / (how == pacs::Retrieval::get ? "get" : "move");
    EXPECT_EQ(
        pacs::retrieve(archive.node(), found[0].study_uid, found[0].series_uid, got, how, monitor).images, 1);
  }
}

}  // namespace
}  // namespace facenav::testing
