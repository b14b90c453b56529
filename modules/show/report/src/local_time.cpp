#include "facenav/report/local_time.h"

#include <cmath>
#include <ctime>

#include "facenav/core/utc_time.h"

namespace facenav::report {
namespace {

constexpr std::size_t kPlainSize = 20;  // of 2026-11-23T14:05:09Z, without milliseconds
constexpr std::size_t kNameSize = 16;   // of 20261123T140509Z; a session's name may go on with _2

std::string local(const std::string& utc, const char* form) {
  auto seconds = secondsOfUtc(utc);
  if (!seconds && utc.size() == kPlainSize && utc.back() == 'Z')
    seconds = secondsOfUtc(utc.substr(0, kPlainSize - 1) + ".000Z");
  if (!seconds && utc.size() > kNameSize) seconds = secondsOfUtc(utc.substr(0, kNameSize));
  if (!seconds) return utc;
  const auto time = std::time_t(std::floor(*seconds));
  std::tm parts{};
  if (!::localtime_r(&time, &parts)) return utc;
  char words[64];
  const std::size_t size = std::strftime(words, sizeof words, form, &parts);
  return std::string(words, size);
}

}  // namespace

std::string localTime(const std::string& utc) { return local(utc, "%Y-%m-%d %H:%M:%S"); }
std::string localClock(const std::string& utc) { return local(utc, "%H:%M:%S"); }
std::string localTimeAndZone(const std::string& utc) { return local(utc, "%Y-%m-%d %H:%M:%S (UTC%z)"); }

}  // namespace facenav::report
