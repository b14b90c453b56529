#include "facenav/casefile/case_place.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(CasePlace, IsTriedBeforeTheWork) {
  const facenav::testing::TemporaryFolder folder;
  EXPECT_NO_THROW(requireWritablePlace(folder.path() / "case", false));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "the trial leaves nothing";
  EXPECT_THROW(requireWritablePlace(folder.path() / "none/case", false), Error);
  EXPECT_THROW(requireWritablePlace("/proc/case", false), Error);
  std::filesystem::create_directory(folder.path() / "photos");
  writeWholeFile(folder.path() / "photos/a", "x");
  EXPECT_THAT([&] { requireWritablePlace(folder.path() / "photos", true); },
              ThrowsMessage<Error>(HasSubstr("is no case")));
  std::filesystem::create_directory(folder.path() / "case");
  writeWholeFile(folder.path() / "case/case.json", "{}");
  EXPECT_THAT([&] { requireWritablePlace(folder.path() / "case", false); },
              ThrowsMessage<Error>(HasSubstr("a case exists there already")));
  EXPECT_NO_THROW(requireWritablePlace(folder.path() / "case", true));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "case/case.json"));
}

TEST(CasePlace, ADiskWithoutRoomIsNamed) {
  const facenav::testing::TemporaryFolder folder;
  volume::Volume scan;
  scan.grid.size = {100, 100, 100};
  EXPECT_NO_THROW(requireSpaceFor(folder.path() / "case", scan));
  scan.grid.size = {100000, 100000, 100000};  // a petabyte
  EXPECT_THAT([&] { requireSpaceFor(folder.path() / "case", scan); },
              ThrowsMessage<Error>(HasSubstr("MB left, a case of this scan needs about")));
}

}  // namespace
}  // namespace facenav::casefile
