#include "facenav/core/whole_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "facenav/core/error.h"
#include "support/test_data.h"

namespace facenav {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

unsigned modeOf(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 0777u;
}

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
  WholeFile secret(folder.path() / "b.txt", FileAccess::owner_only);
  EXPECT_THROW(secret.commit(), Error);
}

TEST(WholeFile, OfTheOwnerAloneIsPrivateFromTheFirstByte) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "face.png";
  writeWholeFile(path, "of before, for all");
  ASSERT_EQ(::chmod(path.c_str(), 0644), 0);
  WholeFile file(path, FileAccess::owner_only);
  EXPECT_EQ(modeOf(file.temporaryPath()), 0600u) << "before anything is written";
  std::ofstream(file.temporaryPath()) << "secret";
  EXPECT_EQ(modeOf(file.temporaryPath()), 0600u);
  file.commit();
  EXPECT_EQ(modeOf(path), 0600u);
  EXPECT_EQ(readWholeFile(path), "secret");
}

TEST(WholeFile, OfTheOwnerAloneStaysPrivateWhenTheWriterMakesTheFileAnew) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.nii";
  WholeFile file(path, FileAccess::owner_only);
  fs::remove(file.temporaryPath());
  std::ofstream(file.temporaryPath()) << "secret";
  file.commit();
  EXPECT_EQ(modeOf(path), 0600u);
}

TEST(WholeFile, MayBeEmptyWhereThatIsTheContent) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "log", "", FileAccess::owner_only);
  EXPECT_EQ(readWholeFile(folder.path() / "log"), "");
  EXPECT_EQ(modeOf(folder.path() / "log"), 0600u);
}

}  // namespace
}  // namespace facenav
