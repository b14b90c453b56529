#pragma once
// Numbers as text for files and messages, and numbers that people type or files hold. The decimal point is
// '.' in every locale. (Qt sets the locale of the whole program, and plain printf would follow it.)

#include <optional>
#include <string>
#include <vector>

namespace facenav {
inline namespace core {

/// Formats `value` with `decimals` digits after the point.
std::string fixed(double value, int decimals);
/// Like printf, of any length. The compiler checks that `format` and the values agree.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// Largest magnitude that an option, a field or a file may give; microseconds since 1970 are below it.
constexpr double kLargestNumber = 1e16;
/// Returns true for a finite number of at most kLargestNumber.
bool isUsableNumber(double value);
/// Reads the whole text as a usable number; nothing for "nan", "inf", "1e30", "5 mm", "1,5", "".
std::optional<double> numberIn(const std::string& text);
/// Reads "1.5,-20,3": usable numbers with commas between them; empty if one of them is none.
std::vector<double> numbersIn(const std::string& text);

}  // namespace core
}  // namespace facenav
