#include "relay_connection.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "facenav/core/error.h"
#include "facenav/core/log.h"

namespace facenav::links {
namespace {

constexpr double kConnectAgain_s = 1, kLongestGreeting_s = 5, kLongestUntaken_s = 10;
constexpr std::size_t kMostEvents = 64;  // between two looks; newer ones are left out

}  // namespace

RelayConnection::RelayConnection(const std::string& host, int port, const std::string& where)
    : host_(host + ":" + std::to_string(port)), where_(where) {
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_STREAM;
  if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0 || !found)
    throw Error("the host '" + host + "' is not known", where, "give its address, 192.168.0.5");
  std::memcpy(&place_, found->ai_addr, found->ai_addrlen);
  place_size_ = found->ai_addrlen;
  ::freeaddrinfo(found);
  since_.s = Timestamp::now().s - kConnectAgain_s;  // at once
}

RelayConnection::~RelayConnection() {
  if (socket_ >= 0) ::close(socket_);
}

pollfd RelayConnection::wanted() const {
  const bool is_sending = state_ == State::reaching || !unsent_.empty();
  return {socket_, short(POLLIN | (is_sending ? POLLOUT : 0)), 0};
}

void RelayConnection::work(short events) {
  const Timestamp now = Timestamp::now();
  if (state_ == State::away) {
    if (now - since_ >= kConnectAgain_s) connect();
    return;
  }
  if (state_ == State::reaching && (events & (POLLOUT | POLLERR | POLLHUP))) greet();
  if (state_ != State::away && state_ != State::reaching && events != 0) receive();
  if (state_ == State::away) return;
  flush();
  if (state_ != State::joined && now - since_ > kLongestGreeting_s) lose("does not answer as a relay");
  if (state_ == State::joined && now - heard_ > silence_s_) lose("is silent");
  if (!unsent_.empty() && now - moved_ > kLongestUntaken_s) lose("takes nothing");
}

void RelayConnection::connect() {
  since_ = heard_ = moved_ = Timestamp::now();
  socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket_ < 0) return;
  state_ = State::reaching;
  const int on = 1;
  ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&place_), place_size_) == 0) return greet();
  if (errno != EINPROGRESS) lose("is not there");
}

/// Asks for the WebSocket, once the connection stands.
void RelayConnection::greet() {
  int fault = 0;
  socklen_t size = sizeof fault;
  ::getsockopt(socket_, SOL_SOCKET, SO_ERROR, &fault, &size);
  if (fault != 0) return lose("is not there");
  std::string key;
  for (int i = 0; i < 16; ++i) key += char(random_() & 0xFF);
  key = base64(key);
  reader_ = std::make_unique<WebSocketReader>(key);
  unsent_ = webSocketRequest(host_, kSocketIoPath, key);
  state_ = State::greeting;
  flush();
}

void RelayConnection::receive() {
  char bytes[16384];
  const ssize_t size = ::recv(socket_, bytes, sizeof bytes, 0);
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (size <= 0) return lose("has gone");
  heard_ = Timestamp::now();
  reader_->add(bytes, std::size_t(size));
  while (state_ != State::away) {
    const auto message = reader_->next();
    if (!message) break;
    take(*message);
  }
  if (state_ != State::away && !reader_->fault().empty()) lose(std::string(reader_->fault()));
}

void RelayConnection::take(const WebSocketMessage& message) {
  if (message.kind == WebSocketKind::close) return lose("has closed");
  if (message.kind == WebSocketKind::ping) return put(WebSocketKind::pong, message.content);
  if (message.kind == WebSocketKind::text) take(socketIoPacketFrom(message.content));
}

void RelayConnection::take(const SocketIoPacket& packet) {
  switch (packet.kind) {
    case SocketIoKind::opened:
      silence_s_ = packet.silence_s;
      if (state_ != State::greeting) return;
      state_ = State::joining;
      return put(WebSocketKind::text, kSocketIoJoin);
    case SocketIoKind::joined:
      if (state_ != State::joining) return;
      state_ = State::joined;
      ++joins_;
      why_.clear();
      return logInfo(where_ + ": connected");
    case SocketIoKind::ping:
      return put(WebSocketKind::text, kSocketIoPong);
    case SocketIoKind::refused:
      return lose("refuses clients");
    case SocketIoKind::left:
      return lose("has closed");
    case SocketIoKind::event:
      if (events_.size() < kMostEvents) events_.push_back(packet);
      return;
    case SocketIoKind::other:
      return;
  }
}

void RelayConnection::send(const std::string& event, const nlohmann::json& body) {
  if (state_ != State::joined) return;
  put(WebSocketKind::text, socketIoEvent(event, body));
  flush();
}

void RelayConnection::put(WebSocketKind kind, const std::string& content) {
  if (unsent_.size() > WebSocketReader::kMostMessage) return;  // a peer that only asks
  if (unsent_.empty()) moved_ = Timestamp::now();
  unsent_ += webSocketFrame(kind, content, std::uint32_t(random_()));
}

void RelayConnection::flush() {
  while (!unsent_.empty()) {
    const ssize_t size = ::send(socket_, unsent_.data(), unsent_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (size <= 0) {
      if (size < 0 && errno != EAGAIN && errno != EINTR) lose("has gone");
      return;
    }
    unsent_.erase(0, std::size_t(size));
    moved_ = Timestamp::now();
  }
}

std::optional<SocketIoPacket> RelayConnection::next() {
  if (events_.empty()) return std::nullopt;
  auto packet = std::move(events_.front());
  events_.pop_front();
  return packet;
}

void RelayConnection::lose(const std::string& why) {
  if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  state_ = State::away;
  since_ = Timestamp::now();
  unsent_.clear();
  reader_.reset();
  if (why != why_) logWarning(where_ + ": the relay " + why + "; FaceNav tries again");
  why_ = why;
}

std::string RelayConnection::words() const {
  if (state_ == State::joined) return "connected";
  return why_.empty() ? "connecting" : "the relay " + why_;
}

void RelayConnection::leave(int limit_ms) {
  if (state_ != State::joined) return;
  put(WebSocketKind::text, kSocketIoLeave);
  put(WebSocketKind::close, std::string("\x03\xE8", 2));  // 1000: the usual end
  const Timestamp begin = Timestamp::now();
  while (state_ == State::joined && !unsent_.empty() && (Timestamp::now() - begin) * 1000 < limit_ms) {
    pollfd waiting{socket_, POLLOUT, 0};
    ::poll(&waiting, 1, 10);
    flush();
  }
}

}  // namespace facenav::links
