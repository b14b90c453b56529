#pragma once
// The current time in the form used for folder names and file entries.

#include <string>

namespace facenav::casefile {

/// Returns the current time as 20100412T134501Z.
std::string utcNow();

}  // namespace facenav::casefile
