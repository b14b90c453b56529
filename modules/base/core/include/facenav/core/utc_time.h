#pragma once
// Times of day as text (ISO 8601, UTC, milliseconds), for what people and other tools read.

#include <chrono>
#include <optional>
#include <string>

namespace facenav {
inline namespace core {

/// Time as text: 2026-11-23T14:05:09.123Z.
std::string isoUtc(std::chrono::system_clock::time_point time);
/// Seconds since 1970 of "2026-11-23T14:05:09.123Z" or "20261123T140509Z"; nullopt for other text.
std::optional<double> secondsOfUtc(const std::string& text);

}  // namespace core
}  // namespace facenav
