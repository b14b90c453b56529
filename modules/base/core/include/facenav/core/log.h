#pragma once
// One log for the whole program (stderr). Log an error once, where it is handled. Never log a patient's name.

#include <string>

namespace facenav {
inline namespace core {

void logInfo(const std::string& message);
void logWarning(const std::string& message);
/// Logs a warning the first time only, for what many readers of one file find.
void logWarningOnce(const std::string& message);
/// Suppresses info lines from now on (the CLI's --quiet).
void setLogQuiet(bool is_quiet);

}  // namespace core
}  // namespace facenav
