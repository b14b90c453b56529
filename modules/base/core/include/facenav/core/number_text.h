#pragma once
// Numbers as text for files and messages. The decimal point is '.' in every locale. (Qt sets the locale of
// the whole program, and plain printf would follow it.)

#include <string>

namespace facenav {
inline namespace core {

/// Formats `value` with `decimals` digits after the point.
std::string fixed(double value, int decimals);
/// Like printf, of any length. The compiler checks that `format` and the values agree.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace core
}  // namespace facenav
