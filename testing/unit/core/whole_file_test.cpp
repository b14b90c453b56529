#include "facenav/core/whole_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "facenav/core/error.h"
#include "support/test_data.h"

namespace facenav {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

TEST(WholeFile, AppearsWithItsContentOnCommit) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.json";
  writeWholeFile(path, "content");
  EXPECT_EQ(readWholeFile(path), "content");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(WholeFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  {
    WholeFile file(folder.path() / "a.nii.gz");
    std::ofstream(file.temporaryPath()) << "half";
    EXPECT_EQ(file.temporaryPath().extension(), ".gz");
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(WholeFile, KeepsTheOldFileUntilTheNewOneIsWhole) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  writeWholeFile(path, "old");
  try {
    WholeFile file(path);
    std::ofstream(file.temporaryPath()) << "ne";
    throw Error("disk full");
  } catch (const Error&) {
  }
  EXPECT_EQ(readWholeFile(path), "old");
  writeWholeFile(path, "new");
  EXPECT_EQ(readWholeFile(path), "new");
}

TEST(WholeFile, RefusesAFolderThatDoesNotExist) {
  const TemporaryFolder folder;
  EXPECT_THROW(WholeFile(folder.path() / "absent/a.txt"), Error);
  EXPECT_THROW(readWholeFile(folder.path() / "a.txt"), Error);
  EXPECT_THROW(readWholeFile(folder.path()), Error);
}

TEST(WholeFile, RefusesToCommitWhatWasNeverWritten) {
  const TemporaryFolder folder;
  WholeFile file(folder.path() / "a.txt");
  EXPECT_THROW(file.commit(), Error);
}

}  // namespace
}  // namespace facenav
