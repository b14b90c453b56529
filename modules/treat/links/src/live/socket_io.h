#pragma once
// Packets of Socket.IO 5 over Engine.IO 4 (python-socketio 5, socket.io 4), as texts of a WebSocket. Only
// what a client of a relay needs: open, connect, event, ping, close. Binary events are left out.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace facenav::links {

/// Path of the WebSocket at the server.
constexpr const char* kSocketIoPath = "/socket.io/?EIO=4&transport=websocket";
/// Texts that a client sends.
constexpr const char *kSocketIoJoin = "40", *kSocketIoLeave = "41", *kSocketIoPong = "3";

enum class SocketIoKind { opened, joined, refused, event, ping, left, other };

struct SocketIoPacket {
  SocketIoKind kind = SocketIoKind::other;
  double silence_s = 0;  // opened: a server that is silent so long has gone
  std::string event;     // event: its name
  nlohmann::json body;   // event: its first argument; null if there is none
};

/// Reads a packet. Text that is none, is damaged or nests too deeply is `other`.
SocketIoPacket socketIoPacketFrom(const std::string& text);
/// Text of an event with one argument.
std::string socketIoEvent(const std::string& event, const nlohmann::json& body);

}  // namespace facenav::links
