#pragma once
// A client of an OpenIGTLink server for tests: connects on loopback, sends bytes, and waits for messages.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <string>

#include "facenav/links/igtl_reader.h"

namespace facenav::testing {

class LoopbackClient {
 public:
  explicit LoopbackClient(int port)
      : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)), reader_(1 << 26) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(std::uint16_t(port));
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0) {
      ::close(socket_);
      throw std::runtime_error("no connection");
    }
  }
  ~LoopbackClient() { ::close(socket_); }
  LoopbackClient(const LoopbackClient&) = delete;
  LoopbackClient& operator=(const LoopbackClient&) = delete;

  int socket() const { return socket_; }
  void send(const links::Bytes& bytes) const {
    (void)!::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  void ask(const std::string& type, const std::string& device = {}, int header_version = 1,
           links::Bytes content = {}) const {
    links::IgtlMessage message;
    message.header_version = header_version;
    message.type = type;
    message.device = device;
    message.content = std::move(content);
    send(links::encoded(message));
  }
  /// Returns the next message of that type (empty: any), or nothing when none has come within `limit_ms`.
  std::optional<links::IgtlMessage> next(const std::string& type = {}, int limit_ms = 30000) {
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(limit_ms)) {
      while (auto message = reader_.next())
        if (type.empty() || message->type == type) return message;
      if (!receive(limit_ms)) return std::nullopt;
    }
    return std::nullopt;
  }
  /// Returns one of the next TRANSFORMs, of that name.
  std::optional<links::IgtlMessage> nextPose(const std::string& name) {
    for (int i = 0; i < 20; ++i)
      if (const auto message = next("TRANSFORM"); !message || message->device == name) return message;
    return std::nullopt;
  }
  /// True once the server has closed the connection.
  bool isClosed() {
    while (receive(5000)) {
    }
    return is_closed_;
  }
  /// Makes the client's own buffer small, as a slow computer's.
  void narrow() const {
    const int size = 4096;
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &size, sizeof size);
  }

 private:
  bool receive(int limit_ms) {
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, limit_ms) <= 0) return false;
    std::uint8_t bytes[65536];
    const ssize_t size = ::recv(socket_, bytes, sizeof bytes, 0);
    is_closed_ = size <= 0;
    if (is_closed_) return false;
    reader_.add(bytes, std::size_t(size));
    return true;
  }

  int socket_;
  links::IgtlReader reader_;
  bool is_closed_ = false;
};

}  // namespace facenav::testing
