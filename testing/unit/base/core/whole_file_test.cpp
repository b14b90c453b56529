#include "facenav/core/whole_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
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

TEST(WholeFile, IsPrivateUnlessAskedOtherwise) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "pulses.csv", "1");
  EXPECT_EQ(modeOf(folder.path() / "pulses.csv"), 0600u);
  const auto before = ::umask(0022);
  writeWholeFile(folder.path() / "stereo.yml", "1", FileAccess::by_umask);
  ::umask(before);
  EXPECT_EQ(modeOf(folder.path() / "stereo.yml"), 0644u);
}

TEST(WholeFile, NeverReplacesADeviceAPipeOrAFolder) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink(pipe, folder.path() / "to_pipe");
  fs::create_symlink("/dev/null", folder.path() / "to_null");
  fs::create_symlink(folder.path() / "absent", folder.path() / "to_nothing");
  for (const fs::path& path : {pipe, folder.path() / "to_pipe", folder.path() / "to_null",
                               folder.path() / "to_nothing", folder.path(), fs::path("/dev/null"),
                               fs::path("/dev/stdout"), fs::path("/dev/fd/1"), fs::path("/proc/self/fd/1")})
    EXPECT_THROW(writeWholeFile(path, "1"), Error) << path;
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WholeFile, FollowsALinkAndLeavesIt) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "disk");
  writeWholeFile(folder.path() / "disk/a.txt", "old");
  fs::create_symlink("disk/a.txt", folder.path() / "a.txt");
  writeWholeFile(folder.path() / "a.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "a.txt"));
  EXPECT_EQ(readWholeFile(folder.path() / "disk/a.txt"), "new");
}

TEST(WholeFile, ADashIsStandardOutput) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  std::fflush(stdout);
  const int kept = ::dup(STDOUT_FILENO), file = ::open(out.c_str(), O_WRONLY | O_CREAT, 0600);
  ::dup2(file, STDOUT_FILENO);
  writeWholeFile("-", "content");
  ::dup2(kept, STDOUT_FILENO);
  ::close(kept);
  ::close(file);
  EXPECT_EQ(readWholeFile(out), "content");
  EXPECT_FALSE(fs::exists("-"));
}

}  // namespace
}  // namespace facenav
