#include "facenav/capture/recording.h"

#include <gtest/gtest.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "facenav/core/error.h"
#include "support/recordings.h"
#include "support/test_data.h"

using namespace facenav;
using namespace facenav::capture;
namespace fs = std::filesystem;
namespace support = facenav::testing;
using support::TemporaryFolder;

namespace {

// A recording folder with stereo.yml; the tests add images with the names that other programs use.
fs::path makeFolder(const TemporaryFolder& folder) {
  const fs::path recording = folder.path() / "rec";
  fs::create_directories(recording / "left");
  fs::create_directories(recording / "right");
  cameras::writeRig(support::smallRig(), recording / "stereo.yml");
  return recording;
}

}  // namespace

TEST(Recording, OrdersNamesByNumberNotByLetter) {
  TemporaryFolder folder;
  const fs::path rec = makeFolder(folder);
  for (int i = 8; i < 12; ++i) {  // 8, 9, 10, 11 without zeros, other extensions and prefixes
    cv::imwrite(rec / "left" / ("cam0_" + std::to_string(i) + ".bmp"), support::noiseImage(2 * i));
    cv::imwrite(rec / "right" / (std::to_string(i) + ".tiff"), support::noiseImage(2 * i + 1));
  }
  const Recording recording = openRecording(rec);
  EXPECT_FALSE(recording.has_timestamps);
  EXPECT_EQ(recording.frames_per_s, 60.0);
  const auto source = makeSource(recording);
  for (int i = 8; i < 12; ++i) {
    const auto frame = source->next();
    EXPECT_EQ(frame->number, i);
    EXPECT_NEAR(frame->captured.s, (i - 8) / 60.0, 1e-12);
    EXPECT_EQ(cv::norm(frame->left, support::noiseImage(2 * i)), 0);
    EXPECT_EQ(cv::norm(frame->right, support::noiseImage(2 * i + 1)), 0);
  }
}

TEST(Recording, ConvertsColourAndSixteenBits) {
  TemporaryFolder folder;
  const fs::path rec = makeFolder(folder);
  cv::Mat colour, twelve_bits, grey = support::noiseImage(5);
  cv::cvtColor(grey, colour, cv::COLOR_GRAY2BGR);
  grey.at<std::uint8_t>(0, 0) = 255;
  grey.convertTo(twelve_bits, CV_16U, 4095.0 / 255.0);
  cv::imwrite(rec / "left" / "1.png", colour);
  cv::imwrite(rec / "right" / "1.png", twelve_bits);
  const auto frame = makeSource(openRecording(rec))->next();
  EXPECT_EQ(frame->left.type(), CV_8U);
  EXPECT_LE(cv::norm(frame->left, support::noiseImage(5), cv::NORM_INF), 1);
  EXPECT_LE(cv::norm(frame->right, grey, cv::NORM_INF), 1);
}

TEST(Recording, ACaptureOfThePlainPairAloneIsEnough) {
  TemporaryFolder folder;
  const fs::path rec = makeFolder(folder);
  fs::create_directories(rec / "capture");
  cv::imwrite(rec / "capture/plain_left.png", support::noiseImage(1));
  cv::imwrite(rec / "capture/plain_right.png", support::noiseImage(2));
  const Recording recording = openCapture(rec);
  ASSERT_TRUE(recording.capture);
  EXPECT_EQ(cv::norm(recording.capture->pattern.right, support::noiseImage(2)), 0);
  cv::imwrite(rec / "capture/pattern_left.png", support::noiseImage(3));  // its right one is missing
  try {
    openCapture(rec);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("pattern_right"), std::string::npos) << error.what();
  }
}

TEST(Recording, TakesFrameNumbersAndTimesFromTheCsv) {
  TemporaryFolder folder;
  support::writeSmallRecording(folder.path() / "rec", 3, 100);
  std::ofstream(folder.path() / "rec" / "timestamps.csv")
      << "exposure_us,frame,t_s,note\r\n900,7,10.5,a\r\n900,9,10.51,\r\n900,12,10.56,b\r\n";
  const auto source = makeSource(openRecording(folder.path() / "rec"));
  std::vector<std::int64_t> numbers;
  std::vector<double> times_s;
  while (const auto frame = source->next()) {
    numbers.push_back(frame->number);
    times_s.push_back(frame->captured.s);
  }
  EXPECT_EQ(numbers, (std::vector<std::int64_t>{7, 9, 12}));
  EXPECT_EQ(times_s, (std::vector<double>{10.5, 10.51, 10.56}));
}

TEST(Recording, DroppedFramesKeepTheirTimes) {
  TemporaryFolder folder;
  support::writeSmallRecording(folder.path() / "rec", 4);
  for (const char* side : {"left", "right"}) fs::remove(folder.path() / "rec" / side / "000001.png");
  const auto source = makeSource(openRecording(folder.path() / "rec"));
  source->next();
  const auto frame = source->next();
  EXPECT_EQ(frame->number, 2);
  EXPECT_NEAR(frame->captured.s, 0.04, 1e-9);
}

TEST(Recording, PlaysVideos) {
  TemporaryFolder folder;
  const fs::path rec = makeFolder(folder);
  fs::remove_all(rec / "left");
  fs::remove_all(rec / "right");
  for (const std::string side : {"left", "right"}) {
    cv::VideoWriter video((rec / (side + ".avi")).string(), cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 25,
                          cv::Size(64, 48), false);
    if (!video.isOpened()) GTEST_SKIP() << "no FFV1 encoder here";
    for (int i = 0; i < 5; ++i) video.write(support::noiseImage(2 * i + (side == "right")));
  }
  const Recording recording = openRecording(rec);
  EXPECT_EQ(recording.frame_count, 5);
  const auto source = makeSource(recording);
  for (int i = 0; i < 5; ++i) {
    const auto frame = source->next();
    ASSERT_TRUE(frame);
    EXPECT_LE(cv::norm(frame->left, support::noiseImage(2 * i), cv::NORM_INF), 2);
    EXPECT_LE(cv::norm(frame->right, support::noiseImage(2 * i + 1), cv::NORM_INF), 2);
  }
  EXPECT_FALSE(source->next());
}

TEST(Recording, CaptureAloneIsEnoughForOpenCapture) {
  TemporaryFolder folder;
  support::writeSmallRecording(folder.path() / "rec", 1);
  for (const char* side : {"left", "right"}) fs::remove_all(folder.path() / "rec" / side);
  fs::remove(folder.path() / "rec" / "timestamps.csv");
  EXPECT_THROW(openRecording(folder.path() / "rec"), Error);
  const Recording recording = openCapture(folder.path() / "rec");
  EXPECT_EQ(recording.frame_count, 0);
  EXPECT_TRUE(recording.capture);
}
