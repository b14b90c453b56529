#pragma once
// Meaning of a status with which an archive answers a request: PS3.7 annex C, PS3.4 annexes B.2.3 and C.4.

#include <string>
#include <utility>

namespace facenav::pacs {

/// What a failed status means, and what the user can do. `own_title`: ours, as the archive knows it.
std::pair<std::string, std::string> statusInWords(unsigned status, const std::string& own_title);

}  // namespace facenav::pacs
