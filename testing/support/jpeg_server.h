#pragma once
// A network camera: motion JPEG over HTTP on loopback, as IP cameras send it. The test chooses the pictures,
// interrupts it and brings it back at the same address.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <thread>
#include <vector>

namespace facenav::testing {

/// Server for one client at a time. All servers of one period send at the same moments, as cameras with one
/// shutter do.
class JpegServer {
 public:
  /// Function that returns picture number `i` of a connection, as JPEG.
  using Picture = std::function<std::string(int i)>;
  explicit JpegServer(Picture picture, int every_ms = 20)
      : picture_(std::move(picture)), every_ms_(every_ms) {
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
  ~JpegServer() {
    is_stopped_ = true;
    ::shutdown(listener_, SHUT_RDWR);
    ::close(listener_);
    thread_.join();
  }
  JpegServer(const JpegServer&) = delete;
  JpegServer& operator=(const JpegServer&) = delete;

  std::string url() const { return "http://127.0.0.1:" + std::to_string(port_) + "/video"; }
  /// Ends the connection; a new one is served.
  void breakOff() { is_broken_ = true; }
  /// Switches it off: connections are closed at once.
  void switchOff(bool is_off) { is_off_ = is_off; }

  /// Encodes a JPEG at least as large as a real camera's, by a comment of 40 kB: FFmpeg reads so many bytes
  /// first.
  static std::string largeJpeg(const cv::Mat& image, int quality = 95) {
    std::vector<std::uint8_t> jpeg;
    cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, quality});
    const std::string comment = std::string("\xFF\xFE\x9C\x42", 4) + std::string(0x9C42 - 2, ' ');
    return std::string(jpeg.begin(), jpeg.begin() + 2) + comment + std::string(jpeg.begin() + 2, jpeg.end());
  }

 private:
  static bool send(int client, const std::string& text) {
    for (std::size_t sent = 0; sent < text.size();) {
      const ssize_t size = ::send(client, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (size <= 0) return false;
      sent += std::size_t(size);
    }
    return true;
  }
  void run() {
    while (!is_stopped_) {
      const int client = ::accept(listener_, nullptr, nullptr);
      if (client < 0) continue;
      char request[4096];
      if (!is_off_ && ::recv(client, request, sizeof request, 0) > 0) serve(client);
      ::close(client);
    }
  }
  void serve(int client) {
    is_broken_ = false;
    bool is_well =
        send(client, "HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=facenav\r\n\r\n");
    for (int i = 0; is_well && !is_stopped_ && !is_broken_ && !is_off_; ++i) {
      const std::string jpeg = picture_(i);
      is_well = send(client, "--facenav\r\nContent-Type: image/jpeg\r\nContent-Length: " +
                                 std::to_string(jpeg.size()) + "\r\n\r\n" + jpeg + "\r\n");
      std::this_thread::sleep_until(nextShutter());
    }
  }
  /// Next whole multiple of the period.
  std::chrono::steady_clock::time_point nextShutter() const {
    const std::chrono::steady_clock::duration period = std::chrono::milliseconds(every_ms_);
    return std::chrono::steady_clock::time_point(
        (std::chrono::steady_clock::now().time_since_epoch() / period + 1) * period);
  }

  Picture picture_;
  int every_ms_, listener_ = -1, port_ = 0;
  std::atomic<bool> is_stopped_{false}, is_broken_{false}, is_off_{false};
  std::thread thread_;
};

}  // namespace facenav::testing
