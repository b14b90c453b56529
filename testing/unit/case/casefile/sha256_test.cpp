#include "facenav/casefile/sha256.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {
using facenav::testing::TemporaryFolder;

// FIPS 180-4 examples.
TEST(Sha256, GivesThePublishedDigests) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "abc", "abc");
  writeWholeFile(folder.path() / "empty", "");
  EXPECT_EQ(sha256OfFile(folder.path() / "abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256OfFile(folder.path() / "empty"),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_THROW(sha256OfFile(folder.path() / "none"), Error);
}

TEST(Sha256, OfAFolderDependsOnContentAlone) {
  const TemporaryFolder a, b;
  writeWholeFile(a.path() / "1", "x");
  writeWholeFile(a.path() / "2", "y");
  writeWholeFile(b.path() / "Doe^Jane", "y");
  writeWholeFile(b.path() / "zz", "x");
  EXPECT_EQ(sha256OfInput(a.path()), sha256OfInput(b.path()));
  writeWholeFile(b.path() / "zz", "z");
  EXPECT_NE(sha256OfInput(a.path()), sha256OfInput(b.path()));
}

}  // namespace
}  // namespace facenav::casefile
