#include "facenav/core/plain_words.h"

#include <cstdint>
#include <optional>

#include "facenav/core/error.h"

namespace facenav {
inline namespace core {
namespace {

/// Decodes the character at `at` and moves `at` behind it; nothing for invalid UTF-8.
std::optional<std::uint32_t> nextCharacter(const std::string& text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  if (first < 0x80) return first;
  const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC2 ? 1 : -1;
  if (more < 0 || first > 0xF4 || at + std::size_t(more) > text.size()) return std::nullopt;
  std::uint32_t character = first & (0x3Fu >> more);
  for (int i = 0; i < more; ++i) {
    const auto next = static_cast<unsigned char>(text[at++]);
    if ((next & 0xC0) != 0x80) return std::nullopt;
    character = character << 6 | (next & 0x3Fu);
  }
  constexpr std::uint32_t kLeast[] = {0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = character >= 0xD800 && character <= 0xDFFF;
  if (character < kLeast[more] || character > 0x10FFFF || is_surrogate) return std::nullopt;
  return character;
}

bool isControl(std::uint32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029; }
bool turnsDirection(std::uint32_t c) { return (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069); }

}  // namespace

std::string faultOfWords(const std::string& text, std::size_t longest, Lines lines) {
  if (text.size() > longest) return "is longer than " + std::to_string(longest) + " bytes";
  for (std::size_t at = 0; at < text.size();) {
    const auto character = nextCharacter(text, at);
    if (!character) return "is not valid UTF-8";
    const bool is_break = *character == '\n' || *character == '\t' || *character == '\r';
    if (isControl(*character) && !(is_break && lines == Lines::many)) return "contains a control character";
    if (turnsDirection(*character)) return "contains a mark that turns the reading direction";
  }
  return {};
}

void requireName(const std::string& name, const std::string& whose) {
  if (name.find_first_not_of(' ') == std::string::npos) throw Error(whose + " is empty", {}, "give one");
  const std::string fault = faultOfWords(name, kLongestName);
  if (!fault.empty()) throw Error(whose + " " + fault, {}, "choose another");
}

void requireNote(const std::string& note, const std::string& whose) {
  const std::string fault = faultOfWords(note, kLongestNote, Lines::many);
  if (!fault.empty()) throw Error(whose + " " + fault, {}, "type it again");
}

}  // namespace core
}  // namespace facenav
