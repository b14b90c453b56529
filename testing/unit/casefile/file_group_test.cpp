#include "facenav/casefile/file_group.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

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

}  // namespace
}  // namespace facenav::casefile
