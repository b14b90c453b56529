// Videos and network streams as cameras. The network stream is motion JPEG over HTTP, as IP cameras send it,
// from a server in this process on loopback.

#include <gmock/gmock.h>

#include <opencv2/videoio.hpp>

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
  EXPECT_GE(frames, 3);
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
}

}  // namespace
}  // namespace facenav::capture
