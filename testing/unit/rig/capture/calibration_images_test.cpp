#include "facenav/capture/calibration_images.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "facenav/core/error.h"
#include "support/recordings.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::capture;
using ::testing::HasSubstr;
namespace support = facenav::testing;

namespace {

void writeImages(const std::filesystem::path& folder, const std::string& side,
                 const std::vector<int>& numbers) {
  for (const int i : numbers)
    cv::imwrite(folder / (side + std::to_string(i) + ".png"), support::noiseImage(i));
}

std::string messageOf(const std::string& left, const std::string& right) {
  try {
    readCalibrationImages({left}, {right});
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST(CalibrationImages, GlobsAreOrderedByNumber) {
  support::TemporaryFolder folder;
  writeImages(folder.path(), "left", {1, 2, 10, 9});
  writeImages(folder.path(), "right", {10, 9, 2, 1});
  const auto pairs = readCalibrationImages({folder.path() / "left*.png"}, {folder.path() / "right*.png"});
  ASSERT_EQ(pairs.size(), 4u);
  EXPECT_EQ(pairs[1].name, "left2.png, right2.png");
  EXPECT_EQ(pairs[3].name, "left10.png, right10.png");
  EXPECT_EQ(cv::norm(pairs[3].left, support::noiseImage(10)), 0);
}

TEST(CalibrationImages, SayWhatDoesNotFit) {
  support::TemporaryFolder folder;
  writeImages(folder.path(), "left", {1, 2, 3});
  writeImages(folder.path(), "right", {1, 2});
  writeImages(folder.path(), "other", {1, 2, 4});
  const auto path = [&](const char* pattern) { return (folder.path() / pattern).string(); };
  EXPECT_THAT(messageOf(path("nothing*.png"), path("right*.png")), HasSubstr("nothing*.png"));
  EXPECT_THAT(messageOf(path("left*.png"), path("right*.png")),
              HasSubstr("counts differ: 3 left images, 2 right"));
  EXPECT_THAT(messageOf(path("left*.png"), path("other*.png")), HasSubstr("left3.png, other4.png"));
}
