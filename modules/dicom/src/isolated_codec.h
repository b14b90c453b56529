#pragma once
// GDCM's codecs run in a child process: on damaged streams they print to the terminal, abort on assertions
// (Debian ships GDCM 3.0.21 with them) or write out of bounds. The child's end is then this function's empty
// answer.

#include <functional>
#include <string>

namespace facenav::dicom {

/// What `decode` returns, computed in a forked child whose output goes nowhere. Empty when the child failed,
/// crashed, took longer than `time_limit_s`, or gave more than `most_bytes`.
std::string runIsolated(const std::function<std::string()>& decode, std::size_t most_bytes,
                        unsigned time_limit_s = 8);

}  // namespace facenav::dicom
