#include "pulse_message.h"

#include <nlohmann/json.hpp>

namespace facenav::links {
namespace {

/// True for `true` and for a number above 0 (a count of pulses). Words, 0 and lists are no pulses.
bool isPulse(const nlohmann::json& value) {
  if (value.is_boolean()) return value.get<bool>();
  return value.is_number() && value.get<double>() > 0;
}

}  // namespace

std::optional<PulseMessage> pulseMessageFrom(const std::string& text, std::string& why) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  const auto pulse = json.is_object() ? json.find("pulse") : json.end();
  if (!json.is_object() || pulse == json.end() || !isPulse(*pulse)) {
    why = "a message was no pulse ({\"pulse\": true} is expected): not counted";
    return std::nullopt;
  }
  PulseMessage message;
  const auto intensity = json.find("intensity_pct");
  if (intensity != json.end() && intensity->is_number()) {
    const double pct = intensity->get<double>();
    if (pct >= 0 && pct <= 100) message.intensity_pct = pct;
  }
  const auto coil = json.find("coil");
  if (coil != json.end() && coil->is_string()) message.coil = coil->get<std::string>();
  return message;
}

}  // namespace facenav::links
