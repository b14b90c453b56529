#include "facenav/core/number_text.h"

#include <locale.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {
namespace {

/// While one exists, the calling thread formats numbers in the "C" locale.
class PlainNumbers {
 public:
  PlainNumbers() : before_(::uselocale(plain())) {}
  ~PlainNumbers() { ::uselocale(before_); }
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;

 private:
  static locale_t plain() {
    static const locale_t locale = ::newlocale(LC_ALL_MASK, "C", locale_t{});
    return locale;
  }
  locale_t before_;
};

}  // namespace

std::string fixed(double value, int decimals) {
  char text[400];  // the largest double has 309 digits before the point
  const auto result = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
  FACENAV_EXPECT(result.ec == std::errc(), "too many decimals");
  return {text, result.ptr};
}

std::string formatted(const char* format, ...) {
  const PlainNumbers plain;
  std::va_list values, again;
  va_start(values, format);
  va_copy(again, values);
  const int length = std::vsnprintf(nullptr, 0, format, values);
  va_end(values);
  std::string text(std::size_t(length > 0 ? length : 0), '\0');
  if (length > 0) std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  return text;
}

bool isUsableNumber(double value) { return std::isfinite(value) && std::abs(value) <= kLargestNumber; }

std::optional<double> numberIn(const std::string& text) {
  const char *begin = text.data(), *end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [stop, fault] = std::from_chars(begin, end, value);
  if (begin == end || fault != std::errc() || stop != end || !isUsableNumber(value)) return std::nullopt;
  return value;
}

std::vector<double> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = numberIn(text.substr(begin, end - begin));
    if (!number) return {};
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

}  // namespace core
}  // namespace facenav
