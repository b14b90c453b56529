#include "facenav/casefile/zip_file.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

using facenav::testing::TemporaryFolder;
using ::testing::HasSubstr;

std::string refusal(const std::filesystem::path& file) {
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
    for (int i = 0; i < 3000; ++i) binary_ += char(i * 37);
    writeZip({{"home.json", "{}"}, {"scalp.vtp", binary_}, {"empty", ""}}, file_, FileAccess::owner_only);
  }
  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "case.zip";
  std::string binary_;
};

TEST_F(ZipFile, ComesBackAsItWas) {
  const auto entries = readZip(file_);
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries.at("scalp.vtp"), binary_);
  EXPECT_EQ(entries.at("empty"), "");
}

TEST_F(ZipFile, OtherProgramsOpenIt) {
  const std::string check = "python3 -c \"import zipfile,sys; z=zipfile.ZipFile('" + file_.string() +
                            "'); sys.exit(z.testzip() is not None or len(z.namelist())!=3)\"";
  EXPECT_EQ(std::system(check.c_str()), 0);
}

TEST_F(ZipFile, AChangedByteIsFoundAndNamed) {
  std::string bytes = readWholeFile(file_);
  bytes[bytes.find(binary_) + 100] ^= 1;
  writeWholeFile(file_, bytes);
  EXPECT_THAT(refusal(file_), HasSubstr("'scalp.vtp' has changed"));
}

TEST_F(ZipFile, ACutOrForeignFileIsRefused) {
  const std::string bytes = readWholeFile(file_);
  for (const std::size_t left : {std::size_t(0), std::size_t(10), bytes.size() / 2, bytes.size() - 30}) {
    writeWholeFile(file_, bytes.substr(0, left) + " ");
    EXPECT_NE(refusal(file_), "") << left;
  }
  writeZip({{"../outside", "x"}}, file_, FileAccess::owner_only);
  EXPECT_THAT(refusal(file_), HasSubstr("leads elsewhere"));
}

}  // namespace
}  // namespace facenav::casefile
