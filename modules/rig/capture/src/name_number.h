#pragma once
// The frame number in a file's name.

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace facenav::capture {

/// Number in the last run of digits of the name: 000123.png, left-7.jpg, 12_left.bmp.
inline std::optional<std::int64_t> numberInName(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto last = std::find_if(stem.rbegin(), stem.rend(), is_digit);
  const auto before = std::find_if_not(last, stem.rend(), is_digit);
  const std::string digits(before.base(), last.base());
  if (digits.empty() || digits.size() > 18) return std::nullopt;
  return std::stoll(digits);
}

}  // namespace facenav::capture
