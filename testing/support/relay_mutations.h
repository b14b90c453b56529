#pragma once
// Damaged streams of a Socket.IO relay, the same for each seed, and a receiver that reads everything in them.

#include <algorithm>
#include <random>

#include "live/relay_messages.h"
#include "live/socket_io.h"
#include "live/web_socket.h"

namespace facenav::testing {

/// A frame as a server sends it, without a mask.
inline std::string serverFrame(links::WebSocketKind kind, const std::string& content) {
  std::string frame(1, char(0x80 | std::uint8_t(kind)));
  if (content.size() < 126) {
    frame += char(content.size());
  } else {
    frame += char(126);
    frame += char(content.size() >> 8);
    frame += char(content.size() & 0xFF);
  }
  return frame + content;
}

/// The answer of a server to the request with this key.
inline std::string serverAnswer(const std::string& key) {
  return "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Accept: " +
         links::webSocketAccept(key) + "\r\n\r\n";
}

struct RelayFound {
  int messages = 0, events = 0, lines = 0;
  std::size_t most_held = 0;
};

inline std::string relayStream() {
  using links::WebSocketKind;
  const char* const kTexts[] = {
      R"(0{"sid":"a","upgrades":[],"pingInterval":25000,"pingTimeout":20000})",
      R"(40{"sid":"b"})",
      R"(42["to_neuronavigation",{"topic":"Robot to Neuronavigation: Robot connection status","data":{"data":"Connected"}}])",
      R"(4217["to_neuronavigation",{"topic":"Robot to Neuronavigation: Set objective","data":{"objective":1}}])",
      R"(42["to_neuronavigation",{"topic":"Robot to Neuronavigation: Update robot warning","data":{"robot_warning":"too far"}}])",
      "2",
      "41"};
  std::string stream;
  for (const char* text : kTexts) stream += serverFrame(WebSocketKind::text, text);
  return stream + serverFrame(WebSocketKind::ping, "x") + serverFrame(WebSocketKind::close, "");
}

/// Reads that many damaged streams, each by a reader of its own. Returns the sums.
inline RelayFound readRelayMutations(int count, unsigned seed) {
  std::mt19937 random(seed);
  const std::string key = "dGhlIHNhbXBsZSBub25jZQ==", whole = relayStream(), answer = serverAnswer(key);
  RelayFound found;
  for (int n = 0; n < count; ++n) {
    std::string bytes = n % 8 == 0 ? answer + whole : whole;
    for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t at = random() % bytes.size();
      if (random() % 4 == 0)
        bytes.insert(at, 1, char(random()));
      else if (random() % 8 == 0)
        bytes.resize(std::max<std::size_t>(at, 1));
      else
        bytes[at] = char(random());
    }
    if (n % 8 != 0) bytes = answer + bytes;
    links::WebSocketReader reader(key);
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t size = std::min<std::size_t>(bytes.size() - at, 1 + random() % 300);
      reader.add(bytes.data() + at, size);
      at += size;
      while (const auto message = reader.next()) {
        ++found.messages;
        const auto packet = links::socketIoPacketFrom(message->content);
        found.events += packet.kind == links::SocketIoKind::event;
        found.lines += !links::robotWords(packet.body).empty() || links::saysConnected(packet.body);
      }
      found.most_held = std::max(found.most_held, reader.held());
    }
  }
  return found;
}

}  // namespace facenav::testing
