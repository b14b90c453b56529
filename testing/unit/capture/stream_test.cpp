// Videos and network streams as cameras. The network stream is motion JPEG over HTTP, as IP cameras send it,
// from a server in this process on loopback.

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <thread>

#include "support/camera_contract.h"
#include "support/fake_v4l2.h"
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

/// Sends one picture every 20 ms to whoever connects, one client at a time.
class JpegServer : public testing::CameraBench {
 public:
  JpegServer() {
    listener_ = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address);
    ::listen(listener_, 4);
    socklen_t size = sizeof address;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { run(); });
  }
  ~JpegServer() override {
    is_stopped_ = true;
    ::shutdown(listener_, SHUT_RDWR);
    ::close(listener_);
    thread_.join();
  }
  std::unique_ptr<Camera> open() override { return makeStreamBackend()->open({"stream", url(), "", "", ""}); }
  CameraSettings settings() const override { return streamSettings(); }
  std::string url() const { return "http://127.0.0.1:" + std::to_string(port_) + "/video"; }
  void breakOff() { is_broken_ = true; }

 private:
  static bool send(int client, const std::string& text) {
    return ::send(client, text.data(), text.size(), MSG_NOSIGNAL) == ssize_t(text.size());
  }
  /// Of the size of a real camera's pictures, by a comment of 40 kB: FFmpeg looks at so many bytes first.
  static std::string largeJpeg(int number) {
    std::vector<std::uint8_t> jpeg;
    cv::imencode(".jpg", testing::numberedPicture(kWidth, kHeight, number), jpeg);
    const std::string comment = std::string("\xFF\xFE\x9C\x42", 4) + std::string(0x9C42 - 2, ' ');
    return std::string(jpeg.begin(), jpeg.begin() + 2) + comment + std::string(jpeg.begin() + 2, jpeg.end());
  }
  void run() {
    while (!is_stopped_) {
      const int client = ::accept(listener_, nullptr, nullptr);
      if (client < 0) continue;
      char request[4096];
      if (::recv(client, request, sizeof request, 0) > 0) serve(client);
      ::close(client);
    }
  }
  void serve(int client) {
    is_broken_ = false;
    bool is_well =
        send(client, "HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=facenav\r\n\r\n");
    for (int i = 0; is_well && !is_stopped_ && !is_broken_; ++i) {
      const std::string jpeg = largeJpeg(i);
      is_well = send(client, "--facenav\r\nContent-Type: image/jpeg\r\nContent-Length: " +
                                 std::to_string(jpeg.size()) + "\r\n\r\n" + jpeg + "\r\n");
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  int listener_ = -1, port_ = 0;
  std::atomic<bool> is_stopped_{false}, is_broken_{false};
  std::thread thread_;
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
  JpegServer server;
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
