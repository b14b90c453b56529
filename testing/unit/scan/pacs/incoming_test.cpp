#include "incoming.h"

#include <gtest/gtest.h>

#include <fstream>

#include "facenav/core/error.h"
#include "support/test_data.h"

namespace facenav::pacs {
namespace {

namespace fs = std::filesystem;

TEST(IncomingFolder, TakesItsNameOnlyWhenAllIsThere) {
  const facenav::testing::TemporaryFolder folder;
  {
    const IncomingFolder broken(folder.path() / "a");
    std::ofstream(broken.path() / "x") << "1";
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
  IncomingFolder whole(folder.path() / "a/");
  std::ofstream(whole.path() / "y") << "2";
  std::ofstream(whole.path() / "x") << "1";
  EXPECT_FALSE(fs::exists(folder.path() / "a"));
  EXPECT_EQ(whole.commit(), 2);
  EXPECT_TRUE(fs::exists(folder.path() / "a/000002.dcm"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(IncomingFolder, RefusesWhatHoldsSomethingAndWhatHasNoParent) {
  const facenav::testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "a") << "1";
  EXPECT_THROW(IncomingFolder(folder.path()), Error);
  EXPECT_THROW(IncomingFolder(folder.path() / "none/b"), Error);
  fs::create_directory(folder.path() / "empty");
  EXPECT_EQ(IncomingFolder(folder.path() / "empty").commit(), 0);
}

}  // namespace
}  // namespace facenav::pacs
