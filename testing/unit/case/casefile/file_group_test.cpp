#include "facenav/casefile/file_group.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {
namespace fs = std::filesystem;

class FileGroupTest : public ::testing::Test {
 protected:
  FileGroupTest() : before_(::umask(022)) {
    write(folder_.path() / "key.json", "old");
    write(folder_.path() / "photo.png", "old");
  }
  ~FileGroupTest() override { ::umask(before_); }
  static void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  static unsigned modeOf(const fs::path& path) { return unsigned(fs::status(path).permissions()) & 0777u; }
  std::string text(const std::string& name) const { return readWholeFile(folder_.path() / name); }
  int entries() const {
    return int(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }

  testing::TemporaryFolder folder_;
  mode_t before_;
};

TEST_F(FileGroupTest, PutsEveryFileAndFolderInPlaceForTheUserAlone) {
  FileGroup group(folder_.path());
  EXPECT_EQ(modeOf(group.staging()), 0700u);
  EXPECT_EQ(modeOf(group.staging().parent_path()), 0700u) << "before the first file is written";
  write(group.staging() / "key.json", "new");
  write(group.staging() / "photo.png", "new");
  write(group.staging() / "pictures" / "left.png", "new");
  EXPECT_EQ(text("photo.png"), "old") << "nothing is replaced before all is there";
  group.commit("key.json");
  for (const char* name : {"key.json", "photo.png", "pictures/left.png"}) {
    EXPECT_EQ(text(name), "new") << name;
    EXPECT_EQ(modeOf(folder_.path() / name), 0600u) << name;
  }
  EXPECT_EQ(modeOf(folder_.path() / "pictures"), 0700u);
}

TEST_F(FileGroupTest, WhereOneCannotBeReplacedAllStaysAsItWas) {
  for (const char* blocked : {"key.json", "photo.png", "aaa.png", "zzz.png"}) {
    SCOPED_TRACE(blocked);
    const fs::path place = folder_.path() / blocked;
    const bool was_there = fs::exists(place);
    if (was_there) fs::remove(place);
    write(place / "somebody's.txt", "theirs");  // a folder in the place of a file
    {
      FileGroup group(folder_.path());
      for (const char* name : {"key.json", "photo.png", "aaa.png", "mmm.png", "zzz.png"})
        write(group.staging() / name, "new");
      EXPECT_THROW(group.commit("key.json"), Error);
    }
    EXPECT_EQ(text(std::string(blocked) + "/somebody's.txt"), "theirs");
    for (const char* name : {"key.json", "photo.png"}) {
      if (std::string(name) != blocked) {
        EXPECT_EQ(text(name), "old") << name;
      }
    }
    EXPECT_FALSE(fs::exists(folder_.path() / "mmm.png"));
    fs::remove_all(place);
    if (was_there) write(place, "old");
    EXPECT_EQ(entries(), 2) << "nothing is left behind";
  }
}

TEST_F(FileGroupTest, LeavesNothingBehindWhereItIsNotCommitted) {
  { write(FileGroup(folder_.path()).staging() / "key.json", "new"); }
  EXPECT_EQ(text("key.json"), "old");
  EXPECT_EQ(entries(), 2);
  EXPECT_THROW(FileGroup(folder_.path() / "nowhere"), Error);
}

/// Another program that writes an alignment; it waits with the group open until it is killed.
class OtherProgram {
 public:
  explicit OtherProgram(const fs::path& folder) {
    int ready[2];
    if (::pipe(ready) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      FileGroup group(folder);
      std::ofstream(group.staging() / "photo.png") << "a face";
      if (::write(ready[1], "1", 1) != 1) ::_exit(1);
      for (;;) ::pause();
    }
    ::close(ready[1]);
    char one = 0;
    is_writing_ = ::read(ready[0], &one, 1) == 1;
    ::close(ready[0]);
  }
  ~OtherProgram() { kill(); }
  bool isWriting() const { return is_writing_; }
  void kill() {
    if (process_ > 0) ::kill(process_, SIGKILL), ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  pid_t process_ = 0;
  bool is_writing_ = false;
};

TEST_F(FileGroupTest, WhatAKilledProgramLeftIsRemovedAndWhatALivingOneWritesIsNot) {
  OtherProgram other(folder_.path());
  ASSERT_TRUE(other.isWriting());
  const FileGroup own(folder_.path());
  EXPECT_EQ(entries(), 4) << "the two files, the other program's folder and this one's";
  removeAbandonedGroups(folder_.path());
  EXPECT_EQ(entries(), 4);
  other.kill();
  removeAbandonedGroups(folder_.path());
  EXPECT_EQ(entries(), 3);
  EXPECT_TRUE(fs::is_directory(own.staging()));
  EXPECT_EQ(text("key.json"), "old");
}

TEST_F(FileGroupTest, TheNextGroupRemovesWhatAKilledProgramLeft) {
  {
    OtherProgram other(folder_.path());
    ASSERT_TRUE(other.isWriting());
  }
  EXPECT_EQ(entries(), 3);
  { const FileGroup next(folder_.path()); }
  EXPECT_EQ(entries(), 2);
}

// A process of this number may run on the other machine.
TEST_F(FileGroupTest, WhatAnotherMachineMayBeWritingStaysForADay) {
  const fs::path group = folder_.path() / ".tmp999999999_0_0123abcd_group";
  write(group / "new" / "photo.png", "a face");
  removeAbandonedGroups(folder_.path());
  EXPECT_TRUE(fs::exists(group / "new" / "photo.png"));
  const auto before = fs::file_time_type::clock::now() - std::chrono::hours(25);
  fs::last_write_time(group, before);
  removeAbandonedGroups(folder_.path());
  EXPECT_TRUE(fs::exists(group)) << "a file was added to new/ a moment ago";
  fs::last_write_time(group / "new", before);
  removeAbandonedGroups(folder_.path());
  EXPECT_FALSE(fs::exists(group));
}

TEST_F(FileGroupTest, FoldersWithOtherNamesStay) {
  const auto before = fs::file_time_type::clock::now() - std::chrono::hours(100);
  for (const char* name :
       {".tmp_group", ".tmp12_0_group2", ".tmpab_0_group", "12_0_group", ".tmp0_0_group"}) {
    fs::create_directory(folder_.path() / name);
    fs::last_write_time(folder_.path() / name, before);
  }
  removeAbandonedGroups(folder_.path());
  EXPECT_EQ(entries(), 7);
  removeAbandonedGroups(folder_.path() / "nowhere");
}

// Killed between removing the old key file and placing the new one.
TEST_F(FileGroupTest, TheOnlyCopyOfAFileIsNeverRemoved) {
  const fs::path group = folder_.path() / ".tmp999999999_0_group";
  write(group / "new" / "key.json", "half");
  write(group / "old" / "photo.png", "older");
  write(group / "old" / "gone.png", "only copy");
  for (const fs::path& place : {group, group / "new", group / "old"})
    fs::last_write_time(place, fs::file_time_type::clock::now() - std::chrono::hours(25));
  removeAbandonedGroups(folder_.path());
  EXPECT_FALSE(fs::exists(group / "new"));
  EXPECT_EQ(readWholeFile(group / "old" / "gone.png"), "only copy");
  write(folder_.path() / "gone.png", "new");  // the next alignment has one
  fs::last_write_time(group, fs::file_time_type::clock::now() - std::chrono::hours(25));
  removeAbandonedGroups(folder_.path());
  EXPECT_FALSE(fs::exists(group));
}

}  // namespace
}  // namespace facenav::casefile
