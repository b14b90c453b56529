#pragma once
// Numbers packed as text: base64 of doubles (8 bytes, little end first), compressed by zlib or plain.

#include <optional>
#include <string>
#include <vector>

namespace facenav::efield {

/// Bytes of a base64 text, blanks ignored; nothing if it is none.
std::optional<std::string> bytesOfBase64(const std::string& text);
/// Unpacks doubles; nothing if the text is damaged or no whole number of doubles.
std::optional<std::vector<double>> unpackedNumbers(const std::string& text);

}  // namespace facenav::efield
