// Videos and network streams as cameras. The network stream is motion JPEG over HTTP, as IP cameras send it,
// from a server in this process on loopback.

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <set>
#include <thread>

#include "facenav/core/number_text.h"
#include "support/camera_contract.h"
#include "support/fake_v4l2.h"
#include "support/jpeg_server.h"
#include "support/test_data.h"

namespace facenav::capture {
namespace {

using testing::faultOf;
using ::testing::HasSubstr;

constexpr int kWidth = 64, kHeight = 48;

CameraSettings streamSettings() {
  CameraSettings settings;
  settings.width_px = kWidth;
  settings.height_px = kHeight;
  settings.frames_per_s = 50;
  return settings;
}

class FileBench : public testing::CameraBench {
 public:
  explicit FileBench(std::string path, int pictures = 200) : path_(std::move(path)) {
    cv::VideoWriter writer(path_, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 50, cv::Size(kWidth, kHeight),
                           false);
    for (int i = 0; i < pictures; ++i) writer.write(testing::numberedPicture(kWidth, kHeight, i));
  }
  std::unique_ptr<Camera> open() override { return makeStreamBackend()->open({"stream", path_, "", "", ""}); }
  CameraSettings settings() const override { return streamSettings(); }

 private:
  std::string path_;
};

/// Sends one picture every 20 ms to whoever connects.
class NetworkBench : public testing::CameraBench {
 public:
  std::unique_ptr<Camera> open() override {
    return makeStreamBackend()->open({"stream", server_.url(), "", "", ""});
  }
  CameraSettings settings() const override { return streamSettings(); }
  void breakOff() { server_.breakOff(); }

 private:
  testing::JpegServer server_{
      [](int i) { return testing::JpegServer::largeJpeg(testing::numberedPicture(kWidth, kHeight, i)); }};
};

TEST(Stream, AVideoKeepsTheContractOfCameras) {
  const testing::TemporaryFolder folder;
  FileBench bench((folder.path() / "left.mkv").string());
  testing::expectCameraContract(bench);
}

TEST(Stream, TwoVideosKeepTheContractOfLivePairs) {
  const testing::TemporaryFolder folder;
  FileBench left((folder.path() / "left.mkv").string()), right((folder.path() / "right.mkv").string());
  testing::expectLivePairContract(left, right);
}

TEST(Stream, AVideoPlaysAtItsOwnPaceAndEnds) {
  const testing::TemporaryFolder folder;
  FileBench bench((folder.path() / "short.mkv").string(), 10);
  const auto camera = bench.open();
  camera->configure(bench.settings());
  camera->start();
  const auto first = camera->next(1.0);
  std::optional<CameraPicture> last;
  const auto end = faultOf([&] {
    while (auto picture = camera->next(1.0)) last = picture;
  });
  EXPECT_EQ(end, CameraFault::ended);
  ASSERT_TRUE(first && last);
  EXPECT_NEAR(last->captured - first->captured, 9 * 0.02, 0.003);
  const testing::TemporaryFolder other;
  FileBench left((other.path() / "left.mkv").string(), 10), right((other.path() / "right.mkv").string(), 10);
  const auto pair = testing::openPair(left, right);
  int frames = 0;
  while (pair->next()) ++frames;
  EXPECT_EQ(frames, 10);
}

/// Writes a video whose picture `i` shows the number i; the numbers in `without` are left out.
void film(const std::string& path, int pictures, const std::set<int>& without = {}) {
  cv::VideoWriter writer(path, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 50, cv::Size(kWidth, kHeight),
                         false);
  for (int i = 0; i < pictures; ++i)
    if (!without.count(i)) writer.write(testing::numberedPicture(kWidth, kHeight, i));
}

std::unique_ptr<CameraPairSource> openFiles(const std::string& left, const std::string& right) {
  const auto open = [](const std::string& path) {
    return makeStreamBackend()->open({"stream", path, "", "", ""});
  };
  return openCameraPair(testing::rigOfSize(streamSettings()), open(left), open(right),
                        {streamSettings(), streamSettings()});
}

TEST(Stream, AVideoIsWholeAlsoAfterANetworkStream) {
  const testing::TemporaryFolder folder;
  const std::string left = (folder.path() / "left.mkv").string(),
                    right = (folder.path() / "right.mkv").string();
  film(left, 10);
  film(right, 10);
  EXPECT_EQ(faultOf([] {
              makeStreamBackend()->open({"stream", "http://127.0.0.1:9/video", "", "", ""});
            }),
            CameraFault::missing);
  const auto pair = openFiles(left, right);
  int frames = 0;
  while (pair->next()) ++frames;
  EXPECT_EQ(frames, 10);
}

TEST(Stream, TwoVideosAreReadPairByPairHoweverSlowlyTheyAreAskedFor) {
  const testing::TemporaryFolder folder;
  const std::string left = (folder.path() / "left.mkv").string(),
                    right = (folder.path() / "right.mkv").string();
  film(left, 30);
  film(right, 30);
  const auto pair = openFiles(left, right);
  std::int64_t frames = 0;
  double first_s = 0, last_s = 0;
  while (const auto frame = pair->next()) {
    EXPECT_EQ(frame->number, frames);
    EXPECT_LT(cv::norm(frame->left, frame->right, cv::NORM_INF), 3)
        << "pictures of one number, frame " << frames;
    (frames == 0 ? first_s : last_s) = frame->captured.s;
    if (++frames % 4 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(110));
  }
  EXPECT_EQ(frames, 30);
  EXPECT_NEAR(last_s - first_s, 29 * 0.02, 0.003) << "times are those of the file";
  EXPECT_EQ(pair->missingPairs(), "");
  EXPECT_TRUE(pair->isFromFiles());
}

TEST(Stream, MissingPairsOfTwoFoldersAreNamedByTheirNumbers) {
  const testing::TemporaryFolder folder;
  const auto write = [&](const std::string& side, const std::set<int>& without) {
    std::filesystem::create_directories(folder.path() / side);
    for (int i = 0; i < 12; ++i)
      if (!without.count(i))
        cv::imwrite((folder.path() / side / formatted("%06d.png", i)).string(),
                    testing::numberedPicture(kWidth, kHeight, i));
    return (folder.path() / side).string();
  };
  const auto pair = openFiles(write("l", {5}), write("r", {7, 8}));
  std::vector<std::int64_t> numbers;
  while (const auto frame = pair->next()) {
    EXPECT_EQ(cv::norm(frame->left, frame->right, cv::NORM_INF), 0);
    numbers.push_back(frame->number);
  }
  EXPECT_THAT(numbers, ::testing::ElementsAre(0, 1, 2, 3, 4, 6, 9, 10, 11));
  EXPECT_EQ(pair->missingPairs(),
            "3 pairs are missing: the right file has no partner for left pictures 7, 8; the left file has no "
            "partner for right picture 5");
  EXPECT_THAT(pair->cautions(), ::testing::ElementsAre(pair->missingPairs()));
}

TEST(Stream, AVideoThatEndsEarlierIsSaid) {
  const testing::TemporaryFolder folder;
  const std::string left = (folder.path() / "left.mkv").string(),
                    right = (folder.path() / "right.mkv").string();
  film(left, 20);
  film(right, 20, {6});  // a video of a constant rate does not say where
  const auto pair = openFiles(left, right);
  int frames = 0;
  while (pair->next()) ++frames;
  EXPECT_EQ(frames, 19);
  EXPECT_THAT(pair->missingPairs(),
              HasSubstr("1 pair is missing: the right file has no partner for left picture 19"));
  EXPECT_THAT(pair->missingPairs(), HasSubstr("one file is shorter"));
}

TEST(Stream, EqualPicturesOfAFileAllCount) {
  const testing::TemporaryFolder folder;
  const std::string left = (folder.path() / "left.mkv").string(),
                    right = (folder.path() / "right.mkv").string();
  for (const auto& path : {left, right}) {
    cv::VideoWriter writer(path, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 50, cv::Size(kWidth, kHeight),
                           false);
    for (int i = 0; i < 10; ++i) writer.write(testing::numberedPicture(kWidth, kHeight, 1));
  }
  const auto pair = openFiles(left, right);
  int frames = 0;
  while (pair->next()) ++frames;
  EXPECT_EQ(frames, 10);
}

TEST(Stream, ANetworkStreamKeepsTheContractOfCamerasAndItsEndIsSaid) {
  NetworkBench server;
  testing::expectCameraContract(server);
  const auto camera = server.open();
  camera->configure(server.settings());
  camera->start();
  ASSERT_TRUE(camera->next(2.0));
  EXPECT_THAT(camera->state().clock, HasSubstr("time of arrival"));
  server.breakOff();
  std::string words;
  const auto fault = faultOf(
      [&] {
        for (int i = 0; i < 50; ++i) camera->next(0.2);
      },
      &words);
  EXPECT_EQ(fault, CameraFault::unplugged);
  EXPECT_THAT(words, HasSubstr("the stream broke off"));
}

TEST(Stream, WhatCannotBeOpenedIsNamed) {
  const testing::TemporaryFolder folder;
  std::string words;
  const auto file = (folder.path() / "none.mkv").string();
  EXPECT_EQ(faultOf(
                [&] {
                  makeStreamBackend()->open({"stream", file, "", "", ""});
                },
                &words),
            CameraFault::missing);
  EXPECT_THAT(words, HasSubstr("none.mkv"));
  const auto photo = (folder.path() / "photo.png").string();
  cv::imwrite(photo, testing::numberedPicture(kWidth, kHeight, 1));
  const auto wordsOf = [&](const std::string& address) {
    faultOf([&] { makeStreamBackend()->open({"stream", address, "", "", ""}); }, &words);
    return words;
  };
  EXPECT_THAT(wordsOf(photo), HasSubstr("this is one picture, not a film"));
  std::filesystem::create_directories(folder.path() / "film" / "left");
  std::filesystem::create_directories(folder.path() / "film" / "right");
  EXPECT_THAT(wordsOf((folder.path() / "film").string()), HasSubstr("give its folders left and right"));
  EXPECT_THAT(wordsOf((folder.path() / "film" / "left").string()),
              HasSubstr("there is no picture in this folder"));
}

}  // namespace
}  // namespace facenav::capture
