#include "datagram_output.h"

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include "facenav/core/error.h"

namespace facenav::links {

DatagramOutput::DatagramOutput(const std::string& name, DatagramFormat format, const PlaceToSend& place)
    : ThreadedOutput(name), format_(format) {
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_DGRAM;
  if (::getaddrinfo(place.host.c_str(), std::to_string(place.port).c_str(), &wanted, &found) != 0 || !found)
    throw Error("the host '" + place.host + "' is not known", name, "give its address, 192.168.0.5");
  socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const bool is_connected = socket_ >= 0 && ::connect(socket_, found->ai_addr, found->ai_addrlen) == 0;
  ::freeaddrinfo(found);
  if (!is_connected) {
    if (socket_ >= 0) ::close(socket_);
    throw Error("cannot be sent to", name, "check the network");
  }
  start();
  setReceivers({place.host + ":" + std::to_string(place.port)});
}

DatagramOutput::~DatagramOutput() {
  stop();
  ::close(socket_);
}

void DatagramOutput::work() {
  std::vector<pollfd> nothing;
  waitFor(nothing);
  for (const auto& pulse : takePulses())
    sendText(format_ == DatagramFormat::osc ? oscBundle(pulse) : jsonLine(pulse));
  if (const auto frame = takeFrame()) send(*frame);
}

void DatagramOutput::send(const LiveFrame& frame) {
  const bool is_sent = sendText(format_ == DatagramFormat::osc ? oscBundle(frame) : jsonLine(frame));
  count(is_sent, !is_sent, 0);
}

/// Returns false if the datagram was not taken: nobody listens, or the network is full.
bool DatagramOutput::sendText(const std::string& text) {
  return ::send(socket_, text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL) == ssize_t(text.size());
}

}  // namespace facenav::links
