#pragma once
// One log for the whole program (stderr). Log once, where an error is handled; never a patient's name.

#include <string>

namespace facenav {
inline namespace core {

void logInfo(const std::string& message);
void logWarning(const std::string& message);
/// No info lines after this (the CLI's --quiet).
void setLogQuiet(bool is_quiet);

}  // namespace core
}  // namespace facenav
