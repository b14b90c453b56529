#include "igtl_peer.h"

#include <linux/sockios.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace facenav::links {
namespace {

constexpr double kReadRate = 1 << 20;  // bytes a second that a client may send
constexpr std::size_t kReadAtOnce = 1 << 14;
constexpr std::size_t kMostReplies = 8;
constexpr std::size_t kMostWaiting = 1 << 16;  // with more bytes to send, no request is read
constexpr double kSilent_s = 30;               // a client that takes nothing for so long is dropped
constexpr int kSendBuffer = 1 << 15;           // bytes in the kernel: half a second of poses, not minutes
constexpr int kMostUnsent = 1 << 13;           // with more unread bytes before it, a frame is dropped

bool isDue(IgtlStream& stream) {
  if (!stream.is_on) return false;
  const Timestamp now = Timestamp::now();
  if ((now - stream.sent) * 1e3 < stream.interval_ms) return false;
  stream.sent = now;
  return true;
}

}  // namespace

IgtlMessage transformMessage(const LivePose& pose, std::uint64_t stamp, int header_version) {
  IgtlMessage message;
  message.header_version = header_version;
  message.type = "TRANSFORM";
  message.device = pose.name;
  message.stamp = stamp;
  message.content = transformContent(pose.pose.value_or(Eigen::Isometry3d::Identity()));
  if (header_version >= 2)
    message.metadata = {{"TransformValid", pose.pose ? "1" : "0"}, {"TransformStatus", pose.status}};
  if (header_version >= 2 && !pose.coil.empty()) message.metadata.push_back({"CoilName", pose.coil, 106});
  return message;
}

IgtlMessage toolsMessage(const LiveFrame& frame, bool is_placed, int header_version) {
  IgtlMessage message;
  message.header_version = header_version;
  message.type = is_placed ? "QTDATA" : "TDATA";
  message.device = "FaceNav";
  message.stamp = igtlStamp(frame.utc);
  std::vector<IgtlTool> tools;
  std::vector<IgtlPlacedTool> placed;
  for (const auto& each : frame.poses) {
    if (header_version >= 2) message.metadata.push_back({each.name + "Status", each.status});
    if (!each.pose) continue;
    tools.push_back({each.name, *each.pose});
    placed.push_back({each.name, placeOf(*each.pose)});
  }
  message.content = is_placed ? placedToolsContent(placed) : toolsContent(tools);
  return message;
}

IgtlPeer::IgtlPeer(int socket, std::string address)
    : socket_(socket),
      address_(std::move(address)),
      allowance_(kReadRate),
      refilled_(Timestamp::now()),
      moved_(Timestamp::now()) {
  const int on = 1, unacknowledged_ms = int(kSilent_s * 1e3);
  ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  ::setsockopt(socket_, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  ::setsockopt(socket_, IPPROTO_TCP, TCP_USER_TIMEOUT, &unacknowledged_ms, sizeof unacknowledged_ms);
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof kSendBuffer);
}

IgtlPeer::~IgtlPeer() { ::close(socket_); }

void IgtlPeer::end(const std::string& reason) {
  if (reason_.empty()) reason_ = reason;
}

short IgtlPeer::events() {
  const Timestamp now = Timestamp::now();
  allowance_ = std::min(kReadRate, allowance_ + (now - refilled_) * kReadRate);
  refilled_ = now;
  const bool may_read = allowance_ >= double(kReadAtOnce) && mayAsk();
  return short((may_read ? POLLIN : 0) | (pending_.empty() ? 0 : POLLOUT));
}

void IgtlPeer::read() {
  std::uint8_t bytes[kReadAtOnce];
  const ssize_t size = ::recv(socket_, bytes, sizeof bytes, MSG_DONTWAIT);
  if (size > 0) {
    allowance_ -= double(size);
    reader_.add(bytes, std::size_t(size));
  } else if (size == 0 || (errno != EAGAIN && errno != EINTR)) {
    end("has gone");
  }
}

/// True if the client may send a request now. Else it waits until the answers to earlier ones are sent.
bool IgtlPeer::mayAsk() const {
  return !waits_for_content_ && pending_.size() < kMostReplies && waiting() < kMostWaiting;
}

std::optional<IgtlMessage> IgtlPeer::nextRequest() {
  if (!mayAsk()) return std::nullopt;
  auto message = reader_.next();
  if (reader_.isBroken()) end("does not speak OpenIGTLink");
  if (message) header_version_ = std::max(header_version_, message->header_version);
  return message;
}

/// True if the client has read nearly all that was sent before.
bool IgtlPeer::mayBurden() const {
  int unsent = 0;
  return pending_.empty() && (::ioctl(socket_, SIOCOUTQ, &unsent) != 0 || unsent <= kMostUnsent);
}

bool IgtlPeer::send(const LiveFrame& frame) {
  if (!mayBurden()) return false;
  const std::uint64_t stamp = igtlStamp(frame.utc);
  if (takes_transforms_)
    for (const auto& pose : frame.poses)
      if (!write(transformMessage(pose, stamp, header_version_))) return false;
  if (isDue(tools_) && !write(toolsMessage(frame, false, header_version_))) return false;
  return !isDue(placed_tools_) || write(toolsMessage(frame, true, header_version_));
}

/// Sends the message in one write. Returns false, and keeps the rest, if the socket did not take all of it.
bool IgtlPeer::write(const IgtlMessage& message) {
  if (!pending_.empty()) return false;
  reply(message);
  return pending_.empty();
}

void IgtlPeer::reply(IgtlMessage message) {
  message.header_version = header_version_;
  message.id = ++id_;
  reply(std::make_shared<const Bytes>(encoded(message)));
}

void IgtlPeer::reply(std::shared_ptr<const Bytes> message) {
  if (pending_.empty()) moved_ = Timestamp::now();
  pending_.push_back(std::move(message));
  flush();
}

void IgtlPeer::flush() {
  while (!pending_.empty() && reason_.empty()) {
    const Bytes& first = *pending_.front();
    const ssize_t size = ::send(socket_, first.data() + sent_of_first_, first.size() - sent_of_first_,
                                MSG_DONTWAIT | MSG_NOSIGNAL);
    if (size < 0) {
      if (errno != EAGAIN && errno != EINTR) end("has gone");
      return;
    }
    moved_ = Timestamp::now();
    sent_of_first_ += std::size_t(size);
    if (sent_of_first_ < first.size()) return;
    pending_.pop_front();
    sent_of_first_ = 0;
  }
}

bool IgtlPeer::isOver() const {
  return !reason_.empty() || (!pending_.empty() && Timestamp::now() - moved_ > kSilent_s);
}

std::size_t IgtlPeer::waiting() const {
  std::size_t sum = 0;
  for (const auto& each : pending_) sum += each->size();
  return sum - sent_of_first_;
}

std::string IgtlPeer::words() const { return address_ + ", header " + std::to_string(header_version_); }

}  // namespace facenav::links
