#include "socket_io.h"

#include <algorithm>

namespace facenav::links {
namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 32;  // of nested lists and objects
constexpr double kShortestSilence_s = 1, kLongestSilence_s = 300, kUsualSilence_s = 45;

/// JSON of a text from outside; discarded where it is damaged or nests too deeply. Brackets in texts count,
/// too: such a packet is left out, which does no harm.
Json parsed(const std::string& text) {
  int depth = 0, deepest = 0;
  for (const char c : text) {
    depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    deepest = std::max(deepest, depth);
  }
  return deepest > kDeepest ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
}

double secondsOf(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_number() ? found->get<double>() / 1000 : 0;
}

SocketIoPacket opened(const Json& json) {
  SocketIoPacket packet;
  if (!json.is_object()) return packet;
  packet.kind = SocketIoKind::opened;
  const double said_s = secondsOf(json, "pingInterval") + secondsOf(json, "pingTimeout");
  packet.silence_s = said_s > 0 ? std::clamp(said_s, kShortestSilence_s, kLongestSilence_s) : kUsualSilence_s;
  return packet;
}

/// A message of Socket.IO: its kind is the first character.
SocketIoPacket message(const std::string& text) {
  SocketIoPacket packet;
  const char kind = text.empty() ? ' ' : text[0];
  if (kind == '0') packet.kind = SocketIoKind::joined;
  if (kind == '1') packet.kind = SocketIoKind::left;
  if (kind == '4') packet.kind = SocketIoKind::refused;
  if (kind != '2') return packet;
  const auto begin = text.find('[');  // after an optional number that asks for an answer
  if (begin == std::string::npos || text.find_first_not_of("0123456789", 1) != begin) return packet;
  const Json json = parsed(text.substr(begin));
  if (!json.is_array() || json.empty() || !json[0].is_string()) return packet;
  packet.kind = SocketIoKind::event;
  packet.event = json[0].get<std::string>();
  if (json.size() > 1) packet.body = json[1];
  return packet;
}

}  // namespace

SocketIoPacket socketIoPacketFrom(const std::string& text) {
  SocketIoPacket packet;
  if (text.empty()) return packet;
  if (text[0] == '0') return opened(parsed(text.substr(1)));
  if (text[0] == '1') packet.kind = SocketIoKind::left;
  if (text[0] == '2') packet.kind = SocketIoKind::ping;
  if (text[0] == '4') return message(text.substr(1));
  return packet;
}

std::string socketIoEvent(const std::string& event, const Json& body) {
  return "42" + Json::array({event, body}).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace facenav::links
