#pragma once
// A pulse message of another program: {"pulse": true} (or a number above 0), optionally with "intensity_pct"
// and with "coil", the name of the coil that gave it.

#include <optional>
#include <string>

namespace facenav::links {

struct PulseMessage {
  std::optional<double> intensity_pct;  // 0..100
  std::string coil;                     // empty: not said
};
/// Parses a message; nothing for any other text, and `why` then describes the fault.
std::optional<PulseMessage> pulseMessageFrom(const std::string& text, std::string& why);

}  // namespace facenav::links
