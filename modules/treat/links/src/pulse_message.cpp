#include "pulse_message.h"

#include <nlohmann/json.hpp>

namespace facenav::links {

std::optional<PulseMessage> pulseMessageFrom(const std::string& text, std::string& why) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  const auto pulse = json.is_object() ? json.find("pulse") : json.end();
  if (!json.is_object() || pulse == json.end() || *pulse == false || pulse->is_null()) {
    why = "a message was no pulse ({\"pulse\": true} is expected): not counted";
    return std::nullopt;
  }
  PulseMessage message;
  const auto intensity = json.find("intensity_pct");
  if (intensity != json.end() && intensity->is_number()) {
    const double pct = intensity->get<double>();
    if (pct >= 0 && pct <= 100) message.intensity_pct = pct;
  }
  return message;
}

}  // namespace facenav::links
