#include "web_socket.h"

#include <openssl/evp.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace facenav::links {
namespace {

constexpr const char* kMagic = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";  // RFC 6455, section 1.3
constexpr std::uint8_t kLast = 0x80, kReserved = 0x70, kKind = 0x0F, kMasked = 0x80, kLength = 0x7F;
constexpr std::size_t kMostControl = 125;

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Value of a line of an HTTP header; its name in any case.
std::string headerValue(const std::string& header, const std::string& name) {
  for (std::size_t at = header.find("\r\n"); at != std::string::npos;) {
    const std::size_t begin = at + 2, end = header.find("\r\n", begin);
    const std::string line = header.substr(begin, end == std::string::npos ? end : end - begin);
    at = end;
    const auto colon = line.find(':');
    if (colon == std::string::npos || lowered(line.substr(0, colon)) != name) continue;
    const auto first = line.find_first_not_of(' ', colon + 1);
    return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(' ') + 1 - first);
  }
  return {};
}

void putNumber(std::string& bytes, std::uint64_t number, int size) {
  for (int i = size - 1; i >= 0; --i) bytes += char(number >> (8 * i) & 0xFF);
}

std::uint64_t numberAt(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) number = number << 8 | std::uint8_t(bytes[at + i]);
  return number;
}

}  // namespace

std::string base64(const std::string& bytes) {
  std::vector<unsigned char> text(4 * (bytes.size() / 3 + 1) + 1);
  const int size =
      EVP_EncodeBlock(text.data(), reinterpret_cast<const unsigned char*>(bytes.data()), int(bytes.size()));
  return {reinterpret_cast<const char*>(text.data()), std::size_t(size)};
}

std::string webSocketAccept(const std::string& key) {
  const std::string text = key + kMagic;
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  if (EVP_Digest(text.data(), text.size(), digest, &size, EVP_sha1(), nullptr) != 1) return {};
  return base64({reinterpret_cast<const char*>(digest), size});
}

std::string webSocketRequest(const std::string& host, const std::string& path, const std::string& key) {
  return "GET " + path + " HTTP/1.1\r\nHost: " + host +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: " + key +
         "\r\nSec-WebSocket-Version: 13\r\n\r\n";
}

std::string webSocketFrame(WebSocketKind kind, const std::string& content, std::uint32_t mask) {
  std::string frame(1, char(kLast | std::uint8_t(kind)));
  if (content.size() <= kMostControl) {
    frame += char(kMasked | content.size());
  } else if (content.size() <= 0xFFFF) {
    frame += char(kMasked | 126);
    putNumber(frame, content.size(), 2);
  } else {
    frame += char(kMasked | 127);
    putNumber(frame, content.size(), 8);
  }
  putNumber(frame, mask, 4);
  for (std::size_t i = 0; i < content.size(); ++i)
    frame += char(std::uint8_t(content[i]) ^ std::uint8_t(mask >> (24 - 8 * (i % 4))));
  return frame;
}

void WebSocketReader::add(const char* bytes, std::size_t size) {
  if (fault_.empty()) bytes_.append(bytes, size);
  if (!is_open_ && fault_.empty()) readAnswer();
}

void WebSocketReader::readAnswer() {
  const std::string begin = bytes_.substr(0, 7);
  const auto end = bytes_.find("\r\n\r\n");
  const bool is_http = std::string("HTTP/1.").compare(0, begin.size(), begin) == 0;
  if (!is_http || (end == std::string::npos && bytes_.size() > kMostHeader))
    return void(refuse("is no web server"));
  if (end == std::string::npos) return;
  const std::string header = bytes_.substr(0, end);
  bytes_.erase(0, end + 4);
  const auto blank = header.find(' ');
  const std::string status = blank == std::string::npos ? "" : header.substr(blank + 1, 3);
  if (status != "101" || lowered(headerValue(header, "upgrade")) != "websocket")
    refuse("is no Socket.IO relay (HTTP " + (status.empty() ? "?" : status) + ")");
  else if (headerValue(header, "sec-websocket-accept") != webSocketAccept(key_))
    refuse("answers another client's request");
  else
    is_open_ = true;
}

std::optional<WebSocketMessage> WebSocketReader::next() {
  while (is_open_ && fault_.empty()) {
    const std::size_t before = bytes_.size();
    if (auto message = readFrame()) return message;
    if (bytes_.size() == before) break;  // not a whole frame; else it was a part of a message
  }
  return std::nullopt;
}

std::optional<WebSocketMessage> WebSocketReader::readFrame() {
  if (bytes_.size() < 2) return std::nullopt;
  const auto first = std::uint8_t(bytes_[0]), second = std::uint8_t(bytes_[1]);
  if (first & kReserved) return refuse("sends a WebSocket extension that was not asked for");
  if (second & kMasked) return refuse("masks its messages, as only clients may");
  std::uint64_t size = second & kLength;
  const std::size_t more = size == 126 ? 2 : size == 127 ? 8 : 0;
  if (bytes_.size() < 2 + more) return std::nullopt;
  if (more > 0) size = numberAt(bytes_, 2, more);
  const bool is_control = first & 0x08;
  if (is_control && (size > kMostControl || !(first & kLast))) return refuse("sends a broken message");
  if (size > kMostMessage || parts_.size() + size > kMostMessage) return refuse("sends too long a message");
  if (bytes_.size() < 2 + more + size) return std::nullopt;
  std::string content = bytes_.substr(2 + more, std::size_t(size));
  bytes_.erase(0, 2 + more + std::size_t(size));
  if (is_control) {
    const auto kind = WebSocketKind(first & kKind);
    if (kind > WebSocketKind::pong) return refuse("sends an unknown kind of message");
    return WebSocketMessage{kind, std::move(content)};
  }
  return join(first, std::move(content));
}

/// A part of a message, or all of it.
std::optional<WebSocketMessage> WebSocketReader::join(std::uint8_t first, std::string content) {
  const auto kind = WebSocketKind(first & kKind);
  if (kind > WebSocketKind::binary) return refuse("sends an unknown kind of message");
  if ((kind == WebSocketKind::more) != parts_kind_.has_value()) return refuse("sends a broken message");
  if (!parts_kind_) parts_kind_ = kind;
  parts_ += content;
  if (!(first & kLast)) return std::nullopt;
  WebSocketMessage message{*parts_kind_, std::move(parts_)};
  parts_.clear();
  parts_kind_.reset();
  return message;
}

std::optional<WebSocketMessage> WebSocketReader::refuse(const std::string& fault) {
  fault_ = fault;
  bytes_.clear();
  parts_.clear();
  return std::nullopt;
}

}  // namespace facenav::links
