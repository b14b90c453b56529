#include "facenav/core/zip_file.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav {
namespace {

using facenav::testing::TemporaryFolder;
using ::testing::HasSubstr;

std::string refusalOfZip(const std::filesystem::path& file) {
  try {
    readZip(file);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

class ZipFile : public ::testing::Test {
 protected:
  void SetUp() override {
    unsigned state = 1;
    for (int i = 0; i < 3000; ++i) noise_ += char((state = state * 1664525u + 1013904223u) >> 24);
    writeZip({{"home.json", "{}"}, {"meshes/scalp.vtp", noise_}, {"empty", ""}}, file_,
             FileAccess::owner_only);
  }
  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "case.zip";
  std::string noise_;
};

TEST_F(ZipFile, ComesBackAsItWas) {
  const auto entries = readZip(file_);
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries.at("meshes/scalp.vtp"), noise_);
  EXPECT_EQ(entries.at("empty"), "");
}

TEST_F(ZipFile, EqualEntriesGiveEqualBytesForTheOwnerOnly) {
  const auto again = folder_.path() / "again.zip";
  writeZip(readZip(file_), again);
  EXPECT_EQ(readWholeFile(again), readWholeFile(file_));
  EXPECT_EQ(std::filesystem::status(file_).permissions() & std::filesystem::perms::all,
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST_F(ZipFile, OneFileIsReadAloneUpToALimit) {
  const auto names = zipNames(file_);
  EXPECT_EQ(names.size(), 3u);
  EXPECT_EQ(readZipEntry(file_, "meshes/scalp.vtp", noise_.size()), noise_);
  EXPECT_THROW(readZipEntry(file_, "meshes/scalp.vtp", noise_.size() - 1), Error);
  EXPECT_THROW(readZipEntry(file_, "meshes", 100), Error);
}

TEST_F(ZipFile, OtherProgramsOpenIt) {
  const std::string check = "python3 -c \"import zipfile,sys; z=zipfile.ZipFile('" + file_.string() +
                            "'); sys.exit(z.testzip() is not None or len(z.namelist())!=3)\"";
  EXPECT_EQ(std::system(check.c_str()), 0);
}

TEST_F(ZipFile, AChangedByteIsFoundAndNamed) {
  std::string bytes = readWholeFile(file_);
  bytes[bytes.find(noise_.substr(100, 50)) + 10] ^= 1;  // noise is stored as it is
  writeWholeFile(file_, bytes);
  EXPECT_THAT(refusalOfZip(file_), HasSubstr("'meshes/scalp.vtp' is damaged"));
}

TEST_F(ZipFile, ACutOrForeignFileIsRefusedInOneLine) {
  const std::string bytes = readWholeFile(file_);
  for (const std::size_t left : {std::size_t(0), std::size_t(10), bytes.size() / 2, bytes.size() - 30}) {
    writeWholeFile(file_, bytes.substr(0, left) + " ");
    EXPECT_NE(refusalOfZip(file_), "") << left;
    EXPECT_EQ(refusalOfZip(file_).find('\n'), std::string::npos);
  }
  writeZip({{"../outside", "x"}}, file_);
  EXPECT_THAT(refusalOfZip(file_), HasSubstr("leads elsewhere"));
  EXPECT_THAT(refusalOfZip(folder_.path() / "none.zip"), HasSubstr("none.zip"));
}

}  // namespace
}  // namespace facenav
