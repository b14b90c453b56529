#pragma once
// Numbers as text for files and messages. The decimal point is a '.' whatever the user's locale (Qt sets it
// for the whole program, and plain printf follows it).

#include <string>

namespace facenav {
inline namespace core {

/// `value` with `decimals` digits behind the point.
std::string fixed(double value, int decimals);
/// As printf would write it, of any length; the compiler checks that `format` and values agree.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace core
}  // namespace facenav
