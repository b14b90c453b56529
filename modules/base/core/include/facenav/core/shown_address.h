#pragma once
// The address of a camera or a server as it may be shown, written to a file and logged: without passwords.
// Errors, warnings and the log pass through it, whoever wrote their words.

#include <string>

namespace facenav {
inline namespace core {

/// Words with every address in them without its password: "rtsp://doe:secret@host/left" becomes
/// "rtsp://doe@host/left", "http://host/video?user=doe&pwd=secret" becomes "http://host/video?user=doe&pwd=".
/// A password may hold '/', '@', ':' and blanks. Words without an address stay as they are.
std::string shownAddress(const std::string& words);

}  // namespace core
}  // namespace facenav
