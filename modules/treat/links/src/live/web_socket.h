#pragma once
// Messages of a WebSocket (RFC 6455) as a client sends and reads them, without a socket. No TLS, no
// compression. Bytes come from outside: every length is checked, and a message has a greatest size.

#include <cstdint>
#include <optional>
#include <string>

namespace facenav::links {

/// Kinds of frames, with the numbers of RFC 6455.
enum class WebSocketKind : std::uint8_t { more = 0, text = 1, binary = 2, close = 8, ping = 9, pong = 10 };

struct WebSocketMessage {
  WebSocketKind kind = WebSocketKind::text;
  std::string content;
};

/// A whole frame as a client must send it. `mask`: any number, another one each time.
std::string webSocketFrame(WebSocketKind kind, const std::string& content, std::uint32_t mask);
/// Request that turns an HTTP connection into a WebSocket; `key`: 16 random bytes in base64.
std::string webSocketRequest(const std::string& host, const std::string& path, const std::string& key);
/// The answer that proves that the server read the key.
std::string webSocketAccept(const std::string& key);
std::string base64(const std::string& bytes);

class WebSocketReader {
 public:
  /// `key`: that of the request, whose answer is read first.
  explicit WebSocketReader(std::string key) : key_(std::move(key)) {}

  void add(const char* bytes, std::size_t size);
  /// Next whole message; nothing: more bytes are needed, or it is broken.
  std::optional<WebSocketMessage> next();
  /// True once the server has agreed to the WebSocket.
  bool isOpen() const { return is_open_; }
  /// What is wrong, in words; empty: nothing. No message follows.
  const std::string& fault() const { return fault_; }
  /// Bytes that are kept.
  std::size_t held() const { return bytes_.size() + parts_.size(); }

  static constexpr std::size_t kMostHeader = 8192, kMostMessage = 1 << 20;

 private:
  void readAnswer();
  std::optional<WebSocketMessage> readFrame();
  std::optional<WebSocketMessage> join(std::uint8_t first, std::string content);
  std::optional<WebSocketMessage> refuse(const std::string& fault);

  std::string key_, bytes_, parts_, fault_;
  std::optional<WebSocketKind> parts_kind_;  // of the message whose first parts have come
  bool is_open_ = false;
};

}  // namespace facenav::links
