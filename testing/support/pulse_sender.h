#pragma once
// Sends pulses to a `udp:PORT` source, as a stimulator's computer does, and records the times.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "facenav/core/timestamp.h"

namespace facenav::testing {

class PulseSender {
 public:
  PulseSender() : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    // A port that is free now; the listener binds it a moment later.
    const int probe = ::socket(AF_INET, SOCK_DGRAM, 0);
    place_.sin_family = AF_INET;
    place_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place_;
    if (socket_ < 0 || ::bind(probe, reinterpret_cast<sockaddr*>(&place_), size) != 0 ||
        ::getsockname(probe, reinterpret_cast<sockaddr*>(&place_), &size) != 0)
      throw std::runtime_error("no free port");
    ::close(probe);
  }
  ~PulseSender() { ::close(socket_); }
  PulseSender(const PulseSender&) = delete;
  PulseSender& operator=(const PulseSender&) = delete;

  std::string source() const { return "udp:127.0.0.1:" + std::to_string(ntohs(place_.sin_port)); }
  /// Sends a pulse and returns the time.
  Timestamp send(double intensity_pct) const {
    char text[96];
    const int size =
        std::snprintf(text, sizeof text, R"({"pulse": true, "intensity_pct": %.3f})", intensity_pct);
    const Timestamp now = Timestamp::now();
    ::sendto(socket_, text, std::size_t(size), 0, reinterpret_cast<const sockaddr*>(&place_), sizeof place_);
    return now;
  }

 private:
  int socket_;
  sockaddr_in place_{};
};

}  // namespace facenav::testing
