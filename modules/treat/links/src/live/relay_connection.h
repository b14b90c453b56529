#pragma once
// RelayConnection: a client of a Socket.IO relay. It never waits: the thread that owns it polls its socket
// and calls work(). It connects again by itself. Who sends looks at isFree() first, so that nothing old
// queues.

#include <poll.h>
#include <sys/socket.h>

#include <deque>
#include <memory>
#include <random>

#include "facenav/core/timestamp.h"
#include "socket_io.h"
#include "web_socket.h"

namespace facenav::links {

class RelayConnection {
 public:
  /// Throws Error if the host is not known.
  RelayConnection(const std::string& host, int port, const std::string& where);
  ~RelayConnection();
  RelayConnection(const RelayConnection&) = delete;
  RelayConnection& operator=(const RelayConnection&) = delete;

  /// What to wait for; a descriptor of -1 is ignored by poll().
  pollfd wanted() const;
  /// Goes on with what is ready, and with what is due by the clock.
  void work(short events);
  /// True once events can be sent.
  bool isJoined() const { return state_ == State::joined; }
  /// Number of times that it was joined so far.
  int joins() const { return joins_; }
  /// True if it is joined and has taken all that was sent.
  bool isFree() const { return isJoined() && unsent_.empty(); }
  /// Sends an event, if it is joined.
  void send(const std::string& event, const nlohmann::json& body);
  /// Next event that came.
  std::optional<SocketIoPacket> next();
  /// "connected", or why not.
  std::string words() const;
  /// Bytes that wait to be sent.
  std::size_t waiting() const { return unsent_.size(); }
  /// Leaves the relay after what waits was sent, within `limit_ms`.
  void leave(int limit_ms);

 private:
  enum class State { away, reaching, greeting, joining, joined };

  void connect();
  void greet();
  void receive();
  void take(const WebSocketMessage& message);
  void take(const SocketIoPacket& packet);
  void put(WebSocketKind kind, const std::string& content);
  void flush();
  void lose(const std::string& why);

  std::string host_, where_, why_;
  sockaddr_storage place_{};
  socklen_t place_size_ = 0;
  int socket_ = -1, joins_ = 0;
  State state_ = State::away;
  std::unique_ptr<WebSocketReader> reader_;
  std::string unsent_;
  std::deque<SocketIoPacket> events_;
  double silence_s_ = 0;
  Timestamp since_, heard_, moved_;  // the state; the last bytes in; the last bytes out
  std::mt19937 random_{std::random_device{}()};
};

}  // namespace facenav::links
