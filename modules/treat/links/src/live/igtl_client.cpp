#include "facenav/links/igtl_client.h"

#include <netdb.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <map>
#include <mutex>
#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/timestamp.h"
#include "facenav/links/igtl_content.h"
#include "facenav/links/igtl_reader.h"

namespace facenav::links {
namespace {

constexpr int kConnectAgain_ms = 1000;
constexpr double kRigidTolerance = 1e-2;
constexpr std::size_t kMostNames = 64;

struct ReceivedPose {
  std::optional<Eigen::Isometry3d> pose;  // nothing: lost
  std::uint64_t stamp = 0;
  Timestamp arrived;
};

/// The pose with its rotation made orthonormal; nothing if it is none.
std::optional<Eigen::Isometry3d> asRigid(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d rotation = pose.linear();
  const bool is_rigid = (rotation * rotation.transpose()).isIdentity(kRigidTolerance) &&
                        rotation.determinant() > 0 && pose.matrix().allFinite();
  if (!is_rigid) return std::nullopt;
  Eigen::Isometry3d clean(Eigen::Quaterniond(rotation).normalized());
  clean.translation() = pose.translation();
  return clean;
}

/// True if the sender says that the pose is lost: by its metadata, or by the identity.
bool isSaidLost(const IgtlMessage& message, const Eigen::Isometry3d& pose) {
  const std::string valid = message.value("TransformValid"), status = message.value("TransformStatus");
  if (!valid.empty()) return valid != "1";
  if (!status.empty()) return status != "OK";
  return pose.matrix().isIdentity(1e-9);
}

}  // namespace

ServedPose servedPoseFrom(const std::string& words) {
  static const std::string kScheme = "igtl://";
  const auto slash = words.find('/', kScheme.size());
  ServedPose served;
  bool is_good = words.rfind(kScheme, 0) == 0 && slash != std::string::npos && slash + 1 < words.size();
  if (is_good) {
    const std::string place = words.substr(kScheme.size(), slash - kScheme.size());
    const auto colon = place.find(':');
    served.host = place.substr(0, colon);
    served.name = words.substr(slash + 1);
    if (colon != std::string::npos) {
      const char* const end = place.data() + place.size();
      const auto [stop, fault] = std::from_chars(place.data() + colon + 1, end, served.port);
      is_good = fault == std::errc() && stop == end && served.port > 0 && served.port < 65536;
    }
  }
  if (!is_good || served.host.empty())
    throw Error("unknown tracker '" + words + "'", {}, "give igtl://HOST[:PORT]/NAME");
  return served;
}

struct IgtlClient::Implementation {
  sockaddr_storage place{};
  socklen_t place_size = 0;
  int wake = -1;
  std::atomic<bool> is_stopping{false}, is_connected{false};
  mutable std::mutex mutex;
  std::map<std::string, ReceivedPose> poses;  // guarded by the mutex
  std::thread thread;

  void run();
  int connect();
  void receiveFrom(int socket);
  short waitFor(int socket, short events, int wait_ms) const;
  void take(const IgtlMessage& message);
  void keep(const std::string& name, std::uint64_t stamp, std::optional<Eigen::Isometry3d> pose);
};

/// Returns the socket's events; 0 after `wait_ms`, or when the client stops.
short IgtlClient::Implementation::waitFor(int socket, short events, int wait_ms) const {
  pollfd waiting[2] = {{wake, POLLIN, 0}, {socket, events, 0}};
  ::poll(waiting, 2, wait_ms);
  return waiting[1].revents;
}

/// Returns a connected socket, or -1.
int IgtlClient::Implementation::connect() {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket < 0) return -1;
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&place), place_size) != 0) {
    int fault = errno;
    socklen_t size = sizeof fault;
    if (fault == EINPROGRESS && waitFor(socket, POLLOUT, kConnectAgain_ms) != 0)
      ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &fault, &size);
    if (fault != 0) {
      ::close(socket);
      return -1;
    }
  }
  return socket;
}

void IgtlClient::Implementation::run() {
  while (!is_stopping) {
    const int socket = connect();
    if (socket < 0) {
      waitFor(-1, 0, kConnectAgain_ms);
      continue;
    }
    is_connected = true;
    receiveFrom(socket);
    is_connected = false;
    ::close(socket);
    std::lock_guard lock(mutex);
    poses.clear();  // time stamps begin anew
  }
}

void IgtlClient::Implementation::receiveFrom(int socket) {
  IgtlReader reader;
  std::uint8_t bytes[16384];
  while (!is_stopping && !reader.isBroken()) {
    if (waitFor(socket, POLLIN, -1) == 0) continue;
    const ssize_t size = ::recv(socket, bytes, sizeof bytes, 0);
    if (size == 0 || (size < 0 && errno != EAGAIN && errno != EINTR)) return;
    if (size < 0) continue;
    reader.add(bytes, std::size_t(size));
    while (const auto message = reader.next()) take(*message);
  }
}

void IgtlClient::Implementation::take(const IgtlMessage& message) {
  if (message.type == "TRANSFORM") {
    if (const auto pose = readTransform(message.content))
      keep(message.device, message.stamp, isSaidLost(message, *pose) ? std::nullopt : asRigid(*pose));
  } else if (message.type == "TDATA") {
    if (const auto tools = readTools(message.content))
      for (const auto& tool : *tools) keep(tool.name, message.stamp, asRigid(tool.pose));
  } else if (message.type == "QTDATA") {
    if (const auto tools = readPlacedTools(message.content))
      for (const auto& tool : *tools) {
        Eigen::Isometry3d pose(tool.place.rotation.normalized());
        pose.translation() = tool.place.position_mm;
        keep(tool.name, message.stamp, asRigid(pose));
      }
  }
}

void IgtlClient::Implementation::keep(const std::string& name, std::uint64_t stamp,
                                      std::optional<Eigen::Isometry3d> pose) {
  std::lock_guard lock(mutex);
  if (poses.size() >= kMostNames && poses.count(name) == 0) return;
  auto& kept = poses[name];
  if (stamp < kept.stamp) return;  // older than what is there
  kept = {std::move(pose), stamp, Timestamp::now()};
}

IgtlClient::IgtlClient(const std::string& host, int port)
    : implementation_(std::make_unique<Implementation>()) {
  auto& client = *implementation_;
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_STREAM;
  if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0 || !found)
    throw Error("the host '" + host + "' is not known", "igtl://" + host, "give its address, 192.168.0.5");
  std::memcpy(&client.place, found->ai_addr, found->ai_addrlen);
  client.place_size = found->ai_addrlen;
  ::freeaddrinfo(found);
  client.wake = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (client.wake < 0) throw Error("no event can be made", "igtl://" + host, "close other programs");
  client.thread = std::thread([&client] {
    try {
      client.run();
    } catch (const std::exception& error) {  // an exception in a thread must not end the program
      logWarning(std::string("the tracker's client stopped: ") + error.what());
    }
  });
}

IgtlClient::~IgtlClient() {
  auto& client = *implementation_;
  client.is_stopping = true;
  const std::uint64_t one = 1;
  (void)!::write(client.wake, &one, sizeof one);
  client.thread.join();
  ::close(client.wake);
}

std::optional<Eigen::Isometry3d> IgtlClient::pose(const std::string& name) const {
  std::lock_guard lock(implementation_->mutex);
  const auto found = implementation_->poses.find(name);
  if (found == implementation_->poses.end()) return std::nullopt;
  if (Timestamp::now() - found->second.arrived > kAgeLimit_s) return std::nullopt;
  return found->second.pose;
}

bool IgtlClient::isConnected() const { return implementation_->is_connected; }

}  // namespace facenav::links
