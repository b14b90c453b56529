#include <charconv>
#include <vector>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/links/pulse_dead_times.h"
#include "sources.h"

namespace facenav::links {
namespace {

[[noreturn]] void refuse(const std::string& words) {
  throw Error("unknown source of pulses '" + words + "'", {}, "use " + pulseSourceWords());
}

std::vector<std::string> partsOf(const std::string& words) {
  std::vector<std::string> parts(1);
  for (const char c : words) {
    if (c == ':')
      parts.emplace_back();
    else
      parts.back().push_back(c);
  }
  return parts;
}

template <class Number>
std::optional<Number> numberFrom(const std::string& text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, number);
  return fault == std::errc() && stop == end && !text.empty() ? std::optional(number) : std::nullopt;
}

/// Removes a trailing "dead=0.15" and returns its value.
std::optional<double> takeDeadTime(std::vector<std::string>& parts, const std::string& words) {
  if (parts.back().rfind("dead=", 0) != 0) return std::nullopt;
  const auto dead_s = numberIn(parts.back().substr(5));
  if (!dead_s || !(*dead_s >= 0 && *dead_s <= 1)) refuse(words);
  parts.pop_back();
  return dead_s;
}

NetworkAddress addressFrom(const std::vector<std::string>& parts, const std::string& words) {
  NetworkAddress address;
  address.is_tcp = parts[0] == "tcp";
  if (parts.size() == 3) address.host = parts[1];
  const auto port = parts.size() == 2 || parts.size() == 3 ? numberFrom<int>(parts.back()) : std::nullopt;
  if (!port || *port < 0 || *port > 65535) refuse(words);
  address.port = *port;
  return address;
}

SerialPort portFrom(const std::vector<std::string>& parts, const std::string& words) {
  SerialPort port;
  if (parts.size() < 2 || parts.size() > 3 || parts[1].empty()) refuse(words);
  port.device = parts[1];
  if (parts.size() == 2) return port;
  if (const auto baud = numberFrom<int>(parts[2]))
    port.baud = *baud;
  else if (parts[2] == "cts" || parts[2] == "dsr")
    port.signal = parts[2] == "cts" ? SerialSignal::cts : SerialSignal::dsr;
  else
    refuse(words);
  return port;
}

}  // namespace

std::string pulseSourceWords() {
  return "udp:PORT, tcp:PORT, serial:DEVICE[:BAUD], serial:DEVICE:cts (or :dsr), "
         "lsl[:STREAM[:MARKER]], "
         "sound[:DEVICE or FILE.wav] (the coil's click); with :dead=SECONDS for another dead time";
}

std::unique_ptr<PulseSource> openPulseSource(const std::string& words) {
  const auto& dead = settingsOf<PulseDeadTimes>();
  auto parts = partsOf(words);
  const auto given_s = takeDeadTime(parts, words);
  if (parts.empty()) refuse(words);  // only a dead time
  if (parts[0] == "udp" || parts[0] == "tcp")
    return makeNetworkSource(words, addressFrom(parts, words), given_s.value_or(dead.network_dead_s));
  if (parts[0] == "serial") {
    const SerialPort port = portFrom(parts, words);
    const bool is_byte = port.signal == SerialSignal::byte;
    return makeSerialSource(words, port,
                            given_s.value_or(is_byte ? dead.serial_byte_dead_s : dead.serial_line_dead_s));
  }
  if (parts[0] == "lsl" && parts.size() <= 3) {
    const LslMarkers markers{parts.size() > 1 ? parts[1] : "", parts.size() > 2 ? parts[2] : ""};
    if (parts.size() > 2 && markers.marker.empty()) refuse(words);
    return makeLslSource(words, markers, given_s.value_or(dead.lsl_dead_s));
  }
  if (parts[0] == "sound") {  // ALSA's names contain colons, too
    std::string input;
    for (std::size_t i = 1; i < parts.size(); ++i) input += (i > 1 ? ":" : "") + parts[i];
    return makeSoundSource(words, input.empty() ? "default" : input, given_s.value_or(dead.sound_dead_s));
  }
  refuse(words);
}

}  // namespace facenav::links
