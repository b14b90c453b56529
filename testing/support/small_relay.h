#pragma once
// A Socket.IO relay for tests: one client at a time on loopback, in this program. It keeps what the client
// sends, and sends what the test says.

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "support/relay_mutations.h"

namespace facenav::testing {

class SmallRelay {
 public:
  enum class Manner { usual, garbage, silent };
  /// `silence_ms`: what it says how often it pings, half as interval, half as time-out.
  explicit SmallRelay(Manner manner = Manner::usual, int silence_ms = 60000)
      : manner_(manner), silence_ms_(silence_ms), listening_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place;
    (void)::bind(listening_, reinterpret_cast<sockaddr*>(&place), size);
    (void)::getsockname(listening_, reinterpret_cast<sockaddr*>(&place), &size);
    (void)::listen(listening_, 1);
    port_ = ntohs(place.sin_port);
    thread_ = std::thread([this] { run(); });
  }
  ~SmallRelay() {
    is_stopping_ = true;
    thread_.join();
    ::close(listening_);
  }

  std::string words() const { return "invesalius:" + std::to_string(port_); }
  int clients() const { return clients_; }
  /// Sends a text of Socket.IO soon.
  void say(const std::string& text) {
    const std::lock_guard lock(mutex_);
    to_say_ += serverFrame(links::WebSocketKind::text, text);
  }
  void drop() { is_dropping_ = true; }
  /// Texts that the client has sent.
  std::vector<std::string> heard() const {
    const std::lock_guard lock(mutex_);
    return heard_;
  }
  /// Bodies of the events with that topic.
  std::vector<nlohmann::json> data(const std::string& topic) const {
    std::vector<nlohmann::json> found;
    for (const auto& text : heard()) {
      const auto packet = links::socketIoPacketFrom(text);
      if (packet.event == "from_neuronavigation" && packet.body["topic"] == topic)
        found.push_back(packet.body["data"]);
    }
    return found;
  }

 private:
  void run() {
    while (!is_stopping_) {
      pollfd waiting{listening_, POLLIN, 0};
      if (::poll(&waiting, 1, 10) <= 0) continue;
      const int client = ::accept(listening_, nullptr, nullptr);
      ++clients_;
      serve(client);
      ::close(client);
      is_dropping_ = false;
    }
  }
  void serve(int client) {
    std::string bytes;
    bool is_open = false;
    while (!is_stopping_ && !is_dropping_) {
      pollfd waiting{client, POLLIN, 0};
      char buffer[65536];
      if (::poll(&waiting, 1, 5) > 0) {
        const ssize_t size = ::recv(client, buffer, sizeof buffer, 0);
        if (size <= 0) return;
        bytes.append(buffer, std::size_t(size));
      }
      if (manner_ == Manner::garbage) {
        send(client, std::string("\x00\xFFgarbage\r\n\r\n", 13));
        continue;
      }
      if (!is_open && manner_ != Manner::silent && bytes.find("\r\n\r\n") != std::string::npos) {
        greet(client, bytes);
        is_open = true;
      }
      while (is_open && take(client, bytes)) {
      }
      const std::lock_guard lock(mutex_);
      send(client, to_say_);
      to_say_.clear();
    }
  }
  void greet(int client, std::string& bytes) {
    const std::string name = "Sec-WebSocket-Key: ";
    const auto key = bytes.find(name) + name.size();
    send(client, serverAnswer(bytes.substr(key, bytes.find("\r\n", key) - key)));
    const std::string half_ms = std::to_string(silence_ms_ / 2);
    send(client, serverFrame(links::WebSocketKind::text, R"(0{"sid":"a","upgrades":[],"pingInterval":)" +
                                                             half_ms + R"(,"pingTimeout":)" + half_ms + "}"));
    bytes.erase(0, bytes.find("\r\n\r\n") + 4);
  }
  /// Takes one masked frame off the bytes.
  bool take(int client, std::string& bytes) {
    if (bytes.size() < 6) return false;
    std::size_t size = std::uint8_t(bytes[1]) & 0x7F, at = 2;
    if (size == 126) {
      if (bytes.size() < 8) return false;
      size = std::size_t(std::uint8_t(bytes[2]) << 8 | std::uint8_t(bytes[3]));
      at = 4;
    }
    if (bytes.size() < at + 4 + size) return false;
    std::string text = bytes.substr(at + 4, size);
    for (std::size_t i = 0; i < size; ++i) text[i] = char(text[i] ^ bytes[at + i % 4]);
    bytes.erase(0, at + 4 + size);
    if (text == "40") send(client, serverFrame(links::WebSocketKind::text, R"(40{"sid":"b"})"));
    const std::lock_guard lock(mutex_);
    heard_.push_back(text);
    return true;
  }
  static void send(int client, const std::string& bytes) {
    if (!bytes.empty()) (void)!::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  Manner manner_;
  int silence_ms_, listening_, port_ = 0;
  std::atomic<int> clients_{0};
  std::atomic<bool> is_stopping_{false}, is_dropping_{false};
  mutable std::mutex mutex_;
  std::vector<std::string> heard_;
  std::string to_say_;
  std::thread thread_;
};

}  // namespace facenav::testing
