#include "facenav/capture/colour_picture.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "facenav/core/error.h"
#include "support/recordings.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::capture;
namespace support = facenav::testing;

namespace {

const cv::Scalar kSkin(120, 150, 200);  // blue, green, red

void overwriteInColour(const std::filesystem::path& file) {
  ASSERT_TRUE(std::filesystem::exists(file));
  cv::imwrite(file.string(), cv::Mat(48, 64, CV_8UC3, kSkin));
}

}  // namespace

TEST(ColourPicture, IsThatOfTheFrameAskedForAndOfThePlainPair) {
  support::TemporaryFolder folder;
  const auto path = folder.path() / "rec";
  support::writeSmallRecording(path, 3, 8);
  overwriteInColour(path / "left" / "000009.png");
  overwriteInColour(path / "capture" / "plain_left.png");
  const Recording recording = openRecording(path);
  const cv::Mat picture = leftColour(recording, 9);
  ASSERT_EQ(picture.type(), CV_8UC3);
  EXPECT_EQ(picture.at<cv::Vec3b>(20, 30), cv::Vec3b(120, 150, 200));
  EXPECT_EQ(captureColour(recording).size(), cv::Size(64, 48));
}

TEST(ColourPicture, GreyPicturesHaveNone) {
  support::TemporaryFolder folder;
  const auto path = folder.path() / "rec";
  support::writeSmallRecording(path, 3, 8);
  const Recording recording = openRecording(path);
  EXPECT_TRUE(leftColour(recording, 8).empty());
  EXPECT_TRUE(captureColour(recording).empty());
  EXPECT_THROW(leftColour(recording, 99), Error);
}
