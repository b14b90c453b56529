#pragma once
// The time as names of folders and entries of files give it.

#include <string>

namespace facenav::casefile {

/// Now, as 20100412T134501Z.
std::string utcNow();

}  // namespace facenav::casefile
