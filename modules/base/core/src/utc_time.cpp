#include "facenav/core/utc_time.h"

#include <cstdio>
#include <ctime>

#include "facenav/core/number_text.h"

namespace facenav {
inline namespace core {

std::string isoUtc(std::chrono::system_clock::time_point time) {
  using std::chrono::milliseconds;
  const auto since_epoch = std::chrono::floor<milliseconds>(time.time_since_epoch()).count();
  const long long ms = (since_epoch % 1000 + 1000) % 1000;
  const std::time_t seconds = std::time_t((since_epoch - ms) / 1000);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  return formatted("%04d-%02d-%02dT%02d:%02d:%02d.%03lldZ", parts.tm_year + 1900, parts.tm_mon + 1,
                   parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec, ms);
}

std::optional<double> secondsOfUtc(const std::string& text) {
  std::tm parts{};
  int ms = 0, read = 0;
  const bool is_long =
      std::sscanf(text.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d.%3dZ%n", &parts.tm_year, &parts.tm_mon,
                  &parts.tm_mday, &parts.tm_hour, &parts.tm_min, &parts.tm_sec, &ms, &read) == 7 &&
      read > 0;
  if (!is_long && (std::sscanf(text.c_str(), "%4d%2d%2dT%2d%2d%2dZ%n", &parts.tm_year, &parts.tm_mon,
                               &parts.tm_mday, &parts.tm_hour, &parts.tm_min, &parts.tm_sec, &read) != 6 ||
                   read == 0))
    return std::nullopt;
  if (!is_long) ms = 0;
  parts.tm_year -= 1900;
  parts.tm_mon -= 1;
  return double(::timegm(&parts)) + 1e-3 * ms;
}

}  // namespace core
}  // namespace facenav
