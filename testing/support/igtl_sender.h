#pragma once
// An OpenIGTLink server of another tracker, for tests: it accepts clients when the test asks and sends them
// what the test says, one write a message.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <vector>

#include "facenav/links/igtl_content.h"

namespace facenav::testing {

class IgtlSender {
 public:
  IgtlSender() : listening_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof at;
    (void)::bind(listening_, reinterpret_cast<sockaddr*>(&at), size);
    (void)::listen(listening_, 4);
    (void)::getsockname(listening_, reinterpret_cast<sockaddr*>(&at), &size);
    port_ = ntohs(at.sin_port);
  }
  ~IgtlSender() {
    for (const int client : clients_) ::close(client);
    ::close(listening_);
  }
  IgtlSender(const IgtlSender&) = delete;
  IgtlSender& operator=(const IgtlSender&) = delete;

  int port() const { return port_; }
  /// "igtl://127.0.0.1:PORT/NAME".
  std::string words(const std::string& name) const {
    return "igtl://127.0.0.1:" + std::to_string(port_) + "/" + name;
  }
  /// Waits for the client. Returns false if none has come within `limit_ms`.
  bool isConnected(int limit_ms = 20000) {
    if (clients_.empty()) acceptOne(limit_ms);
    return !clients_.empty();
  }
  /// Accepts one more client if one comes within `limit_ms`.
  void acceptOne(int limit_ms = 0) {
    pollfd waiting{listening_, POLLIN, 0};
    if (::poll(&waiting, 1, limit_ms) <= 0) return;
    if (const int client = ::accept(listening_, nullptr, nullptr); client >= 0) clients_.push_back(client);
  }
  void send(const links::IgtlMessage& message) const {
    const auto bytes = links::encoded(message);
    for (const int client : clients_) (void)!::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  /// Sends TRANSFORM. `stamp`: 0: that of now.
  void sendPose(const std::string& name, const Eigen::Isometry3d& pose, std::uint64_t stamp = 0,
                std::vector<links::IgtlEntry> metadata = {}) const {
    links::IgtlMessage message;
    message.header_version = metadata.empty() ? 1 : 2;
    message.type = "TRANSFORM";
    message.device = name;
    message.stamp = stamp ? stamp : links::igtlStamp(std::chrono::system_clock::now());
    message.content = links::transformContent(pose);
    message.metadata = std::move(metadata);
    send(message);
  }

 private:
  int listening_ = -1, port_ = 0;
  std::vector<int> clients_;
};

}  // namespace facenav::testing
