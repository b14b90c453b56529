#pragma once
// Error: the one exception type for everything outside the frame loop (files, DICOM, settings, calibration).
// Its message is one line: what happened, where (file, tag, field), and what to do. It is caught at three
// places only: the CLI's main, the presenters' task runner, the session thread. FACENAV_EXPECT checks for
// bugs, in all builds.

#include <filesystem>
#include <stdexcept>
#include <string>

namespace facenav {
inline namespace core {

class Error : public std::runtime_error {
 public:
  /// `what_happened`: the fault in plain words; `where`: file, tag, key or field; `remedy`: what the user can
  /// do. Line breaks are replaced by blanks. Never put a patient's name in any of them.
  Error(const std::string& what_happened, const std::string& where = {}, const std::string& remedy = {});
};

/// Thrown when the user cancelled a long task; nothing has been written.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled, nothing was written") {}
};

/// Reports a violated expectation (a bug) by throwing std::logic_error with file and line.
[[noreturn]] void expectationFailed(const char* condition, const char* file, int line,
                                    const std::string& message);

}  // namespace core
}  // namespace facenav

#define FACENAV_EXPECT(condition, message)                                                   \
  do {                                                                                       \
    if (!(condition)) ::facenav::expectationFailed(#condition, __FILE__, __LINE__, message); \
  } while (false)
