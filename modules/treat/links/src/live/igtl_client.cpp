#include "facenav/links/igtl_client.h"

#include <netdb.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/links/igtl_content.h"
#include "facenav/links/igtl_reader.h"

namespace facenav::links {
namespace {

constexpr int kConnectAgain_ms = 1000;
constexpr double kRigidTolerance = 1e-2;
constexpr std::size_t kMostNames = 64;

// Readings of a tool that are kept, to pair those of one moment: messages of one frame follow each other.
constexpr std::size_t kMostReadings = 4;

/// The pose with its rotation made orthonormal, or why it is none.
IgtlReading asRigid(const Eigen::Isometry3d& pose) {
  IgtlReading reading;
  reading.fault = faultOfPose(pose);
  if (!reading.fault.empty()) return reading;
  reading.pose = Eigen::Isometry3d(Eigen::Quaterniond(Eigen::Matrix3d(pose.linear())).normalized());
  reading.pose->translation() = pose.translation();
  return reading;
}

/// Reads a tool of QTDATA. A quaternion of another length than 1 is no rotation.
IgtlReading asRigid(const IgtlPlace& place) {
  IgtlReading reading;
  const double length = place.rotation.norm();
  if (!(std::abs(length - 1.0) < kRigidTolerance)) {
    reading.fault = formatted("has a quaternion of length %.3g", length);
    return reading;
  }
  Eigen::Isometry3d pose(place.rotation.normalized());
  pose.translation() = place.position_mm;
  return asRigid(pose);
}

/// True if the metadata say that the pose of this key's tool is lost.
bool isSaidLost(const std::string& valid, const std::string& status) {
  return (!valid.empty() && valid != "1" && valid != "true") || (!status.empty() && status != "OK");
}

bool isSame(const IgtlReading& a, const IgtlReading& b) {
  return a.pose.has_value() == b.pose.has_value() && (!a.pose || a.pose->matrix() == b.pose->matrix());
}

bool isOld(const IgtlReading& reading) {
  return Timestamp::now() - reading.arrived > IgtlClient::kAgeLimit_s;
}

}  // namespace

std::string faultOfPose(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d rotation = pose.linear();
  if (!pose.matrix().allFinite()) return "holds numbers that are not finite";
  const double determinant = rotation.determinant();
  if (determinant < 0) return "is mirrored";
  const double scale = std::cbrt(determinant);
  if (std::abs(scale - 1) > kRigidTolerance)
    return formatted("is scaled by %.3g (a rotation and millimetres are expected)", scale);
  if (!(rotation * rotation.transpose()).isIdentity(kRigidTolerance)) return "is sheared";
  return {};
}

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
  std::map<std::string, std::deque<IgtlReading>> tools;  // the newest last; guarded by the mutex
  std::thread thread;

  void run();
  int connect();
  void receiveFrom(int socket);
  short waitFor(int socket, short events, int wait_ms) const;
  void take(const IgtlMessage& message);
  void keep(const std::string& name, std::uint64_t stamp, IgtlReading reading);
  IgtlReading newest(const std::string& name) const;
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
    tools.clear();  // time stamps begin anew
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
    const auto pose = readTransform(message.content);
    if (!pose) return;
    const bool is_lost = isSaidLost(message.value("TransformValid"), message.value("TransformStatus"));
    keep(message.device, message.stamp, is_lost ? IgtlReading() : asRigid(*pose));
    return;
  }
  std::set<std::string> names;  // the first of two equal ones counts
  const auto keepTool = [&](const std::string& name, const IgtlReading& reading) {
    if (!names.insert(name).second) return;
    const bool is_lost = isSaidLost({}, message.value(name + "Status"));
    keep(name, message.stamp, is_lost ? IgtlReading() : reading);
  };
  if (message.type == "TDATA") {
    if (const auto read = readTools(message.content))
      for (const auto& tool : *read) keepTool(tool.name, asRigid(tool.pose));
  } else if (message.type == "QTDATA") {
    if (const auto read = readPlacedTools(message.content))
      for (const auto& tool : *read) keepTool(tool.name, asRigid(tool.place));
  }
}

void IgtlClient::Implementation::keep(const std::string& name, std::uint64_t stamp, IgtlReading reading) {
  if (reading.pose && reading.pose->matrix().isIdentity(1e-9)) reading.pose.reset();
  reading.stamp = stamp;
  reading.arrived = Timestamp::now();
  std::lock_guard lock(mutex);
  if (tools.size() >= kMostNames && tools.count(name) == 0) return;
  auto& kept = tools[name];
  if (!kept.empty()) {
    const auto& last = kept.back();
    if (stamp < last.stamp && !isOld(last)) return;  // after a pause its clock may have been set back
    if (stamp != 0 && stamp == last.stamp && isSame(last, reading)) return;  // the last message again
  }
  kept.push_back(std::move(reading));
  if (kept.size() > kMostReadings) kept.pop_front();
}

/// Newest reading, lost if it is old. Called with the mutex locked.
IgtlReading IgtlClient::Implementation::newest(const std::string& name) const {
  const auto found = tools.find(name);
  if (found == tools.end() || isOld(found->second.back())) {
    IgtlReading none;
    none.fault = !is_connected          ? "the server is not connected"
                 : found == tools.end() ? "the server has sent no pose of this name"
                                        : formatted("no new message for %.2f s", kAgeLimit_s);
    return none;
  }
  return found->second.back();
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
  return read({name}).front().pose;
}

std::vector<IgtlReading> IgtlClient::read(const std::vector<std::string>& names) const {
  const auto& client = *implementation_;
  std::lock_guard lock(client.mutex);
  std::vector<IgtlReading> readings;
  for (const auto& name : names) readings.push_back(client.newest(name));
  // The moment is that of the tool whose newest reading is the oldest. A tool that is lost gives no moment.
  std::uint64_t moment = 0;
  for (const auto& reading : readings)
    if (reading.pose && (moment == 0 || reading.stamp < moment)) moment = reading.stamp;
  if (moment == 0) return readings;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!readings[i].pose) continue;  // lost now: an earlier pose would be an old one
    for (const auto& earlier : client.tools.at(names[i]))
      if (earlier.stamp == moment && !isOld(earlier)) readings[i] = earlier;
  }
  return readings;
}

bool IgtlClient::isConnected() const { return implementation_->is_connected; }

}  // namespace facenav::links
