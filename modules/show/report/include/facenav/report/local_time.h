#pragma once
// Times of day as people read them: local time, of this machine's time zone. Files keep UTC.

#include <string>

namespace facenav::report {

/// "2026-11-23 15:05:09" of "2026-11-23T14:05:09.123Z", of "20261123T140509Z" or of a session's name. Other
/// text is returned unchanged.
std::string localTime(const std::string& utc);
/// Its time alone: "15:05:09".
std::string localClock(const std::string& utc);
/// With the offset from UTC: "2026-11-23 15:05:09 (UTC+0100)".
std::string localTimeAndZone(const std::string& utc);

}  // namespace facenav::report
