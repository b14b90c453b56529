#pragma once
// A pulse as a program sends it: {"pulse": true}, with "intensity_pct" where it knows it.

#include <optional>
#include <string>

namespace facenav::links {

struct PulseMessage {
  std::optional<double> intensity_pct;  // 0..100
};
/// Nothing for any other text; `why` then says what is wrong with it.
std::optional<PulseMessage> pulseMessageFrom(const std::string& text, std::string& why);

}  // namespace facenav::links
