#include "facenav/core/whole_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

unsigned folderModeOf(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 0777u;
}

void write(const fs::path& path, const std::string& content) { std::ofstream(path) << content; }

std::ptrdiff_t entriesIn(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(WholeFolder, AppearsWithItsFilesOnCommit) {
  const TemporaryFolder folder;
  const fs::path place = folder.path() / "out";
  WholeFolder whole(place);
  write(whole.temporaryPath() / "a", "1");
  EXPECT_FALSE(fs::exists(place));
  whole.commit();
  EXPECT_EQ(readWholeFile(place / "a"), "1");
  EXPECT_EQ(entriesIn(folder.path()), 1);
}

TEST(WholeFolder, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  { write(WholeFolder(folder.path() / "out").temporaryPath() / "a", "half"); }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(WholeFolder, TakesAnEmptyFolderAndATrailingSlash) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "out");
  WholeFolder whole(folder.path() / "out/");
  write(whole.temporaryPath() / "a", "1");
  whole.commit();
  EXPECT_EQ(readWholeFile(folder.path() / "out/a"), "1");
}

TEST(WholeFolder, ReplacesWhatWasThereOnlyWhenAsked) {
  const TemporaryFolder folder;
  const fs::path place = folder.path() / "out";
  fs::create_directory(place);
  write(place / "old", "kept");
  EXPECT_THROW(WholeFolder refused(place), Error);
  EXPECT_EQ(readWholeFile(place / "old"), "kept");
  WholeFolder whole(place, FileAccess::by_umask, Existing::replace);
  write(whole.temporaryPath() / "new", "2");
  EXPECT_EQ(readWholeFile(place / "old"), "kept") << "before commit() the old folder stands";
  whole.commit();
  EXPECT_FALSE(fs::exists(place / "old"));
  EXPECT_EQ(readWholeFile(place / "new"), "2");
  EXPECT_EQ(entriesIn(folder.path()), 1) << "the old content is removed";
}

TEST(WholeFolder, DoesNotReplaceWhatCameMeanwhile) {
  const TemporaryFolder folder;
  const fs::path place = folder.path() / "out";
  WholeFolder whole(place);
  fs::create_directory(place);
  write(place / "other", "kept");
  EXPECT_THROW(whole.commit(), Error);
  EXPECT_EQ(readWholeFile(place / "other"), "kept");
}

TEST(WholeFolder, OfTheOwnerAloneIsPrivateFromTheStart) {
  const TemporaryFolder folder;
  const fs::path place = folder.path() / "out";
  WholeFolder whole(place, FileAccess::owner_only);
  EXPECT_EQ(folderModeOf(whole.temporaryPath()), 0700u);
  fs::create_directory(whole.temporaryPath() / "left");
  write(whole.temporaryPath() / "left/a", "1");
  whole.commit();
  EXPECT_EQ(folderModeOf(place), 0700u);
  EXPECT_EQ(folderModeOf(place / "left"), 0700u);
  EXPECT_EQ(folderModeOf(place / "left/a"), 0600u);
}

TEST(WholeFolder, HoldsManyFiles) {  // above the limit for single syncs
  const TemporaryFolder folder;
  WholeFolder whole(folder.path() / "out");
  for (int i = 0; i < 100; ++i) write(whole.temporaryPath() / std::to_string(i), "x");
  whole.commit();
  EXPECT_EQ(entriesIn(folder.path() / "out"), 100);
}

TEST(WholeFolder, RefusesAParentThatDoesNotExist) {
  const TemporaryFolder folder;
  EXPECT_THROW(WholeFolder(folder.path() / "absent/out"), Error);
}

TEST(WholeFolder, NeverReplacesAFileOrADevice) {
  const TemporaryFolder folder;
  write(folder.path() / "a", "kept");
  EXPECT_THROW(WholeFolder(folder.path() / "a", FileAccess::owner_only, Existing::replace), Error);
  EXPECT_THROW(WholeFolder("/dev/null", FileAccess::owner_only, Existing::replace), Error);
  EXPECT_THROW(WholeFolder("-"), Error);
  EXPECT_EQ(readWholeFile(folder.path() / "a"), "kept");
}

TEST(WholeFolder, FollowsALinkAndLeavesIt) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "disk");
  fs::create_symlink("disk", folder.path() / "out");
  WholeFolder whole(folder.path() / "out", FileAccess::owner_only, Existing::replace);
  write(whole.temporaryPath() / "a", "1");
  whole.commit();
  EXPECT_TRUE(fs::is_symlink(folder.path() / "out"));
  EXPECT_EQ(readWholeFile(folder.path() / "disk/a"), "1");
}

}  // namespace
}  // namespace facenav
