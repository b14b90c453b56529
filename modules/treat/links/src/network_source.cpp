#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include "facenav/core/error.h"
#include "pulse_message.h"
#include "sources.h"
#include "threaded_source.h"

namespace facenav::links {
namespace {

constexpr std::size_t kLongestMessage = 4096;
constexpr int kMostClients = 8;

/// Seconds since the kernel received the datagram; 0 if it gives no time.
double ageOf(msghdr& header) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&header); part; part = CMSG_NXTHDR(&header, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec received{}, now{};
    std::memcpy(&received, CMSG_DATA(part), sizeof received);
    ::clock_gettime(CLOCK_REALTIME, &now);
    const double age_s = double(now.tv_sec - received.tv_sec) + 1e-9 * double(now.tv_nsec - received.tv_nsec);
    return age_s > 0 && age_s < kOldestPulse_s ? age_s : 0.0;
  }
  return 0;
}

class NetworkSource : public ThreadedSource {
 public:
  NetworkSource(const std::string& name, NetworkAddress address, double dead_time_s)
      : ThreadedSource(name, dead_time_s), address_(std::move(address)) {}
  ~NetworkSource() override { stop(); }

 private:
  struct Client {
    int socket;
    std::string text;
  };

  void open() override;
  void run() override { address_.is_tcp ? runTcp() : runUdp(); }
  void close() override;
  void runUdp();
  void runTcp();
  void accept();
  bool read(Client& client);
  void take(const std::string& text, double age_s);

  NetworkAddress address_;
  int socket_ = -1;
  std::vector<Client> clients_;
};

void NetworkSource::open() {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(std::uint16_t(address_.port));
  if (::inet_pton(AF_INET, address_.host.c_str(), &place.sin_addr) != 1)
    throw Error("'" + address_.host + "' is no address", name(), "give it as numbers, 192.168.0.5");
  socket_ = ::socket(AF_INET, (address_.is_tcp ? SOCK_STREAM : SOCK_DGRAM) | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  if (address_.is_tcp)
    ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  else
    ::setsockopt(socket_, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
  if (socket_ < 0 || ::bind(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0 ||
      (address_.is_tcp && ::listen(socket_, kMostClients) != 0))
    throw Error(std::string("cannot be listened to (") + std::strerror(errno) + ")", name(),
                "choose another port, or end the program that uses it");
}

void NetworkSource::close() {
  for (auto& client : clients_) ::close(client.socket);
  clients_.clear();
  if (socket_ >= 0) ::close(std::exchange(socket_, -1));
}

void NetworkSource::take(const std::string& text, double age_s) {
  std::string why;
  const auto message = pulseMessageFrom(text, why);
  tellProblem(message ? "" : why);
  if (message) tellPulse(age_s, message->intensity_pct, message->coil);
}

void NetworkSource::runUdp() {
  std::vector<pollfd> waiting{{socket_, POLLIN, 0}};
  std::vector<char> text(kLongestMessage), control(512);
  while (!isStopping()) {
    waitFor(waiting, -1);
    for (;;) {
      iovec part{text.data(), text.size()};
      msghdr header{};
      header.msg_iov = &part, header.msg_iovlen = 1;
      header.msg_control = control.data(), header.msg_controllen = control.size();
      const ssize_t size = ::recvmsg(socket_, &header, 0);
      if (size < 0) break;
      take(std::string(text.data(), std::size_t(size)), ageOf(header));
    }
  }
}

void NetworkSource::accept() {
  const int socket = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (socket < 0) return;
  if (clients_.size() >= kMostClients)
    ::close(socket);
  else
    clients_.push_back({socket, {}});
}

/// Reads a client's messages. Returns false if the client has gone.
bool NetworkSource::read(Client& client) {
  char buffer[1024];
  const ssize_t size = ::recv(client.socket, buffer, sizeof buffer, 0);
  if (size <= 0) return size < 0 && (errno == EAGAIN || errno == EINTR);
  client.text.append(buffer, std::size_t(size));
  for (std::size_t end; (end = client.text.find('\n')) != std::string::npos;) {
    take(client.text.substr(0, end), 0);
    client.text.erase(0, end + 1);
  }
  return client.text.size() <= kLongestMessage;
}

void NetworkSource::runTcp() {
  while (!isStopping()) {
    std::vector<pollfd> waiting{{socket_, POLLIN, 0}};
    for (const auto& client : clients_) waiting.push_back({client.socket, POLLIN, 0});
    waitFor(waiting, -1);
    if (isStopping()) return;
    for (std::size_t i = clients_.size(); i-- > 0;)
      if (waiting[i + 1].revents != 0 && !read(clients_[i])) {
        ::close(clients_[i].socket);
        clients_.erase(clients_.begin() + std::ptrdiff_t(i));
      }
    if (waiting[0].revents != 0) accept();
  }
}

}  // namespace

std::unique_ptr<PulseSource> makeNetworkSource(const std::string& name, const NetworkAddress& address,
                                               double dead_time_s) {
  return std::make_unique<NetworkSource>(name, address, dead_time_s);
}

}  // namespace facenav::links
