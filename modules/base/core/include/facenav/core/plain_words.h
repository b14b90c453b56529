#pragma once
// Names and notes that people type: what may be in them. Every writer that keeps one asks here.

#include <cstddef>
#include <string>

namespace facenav {
inline namespace core {

constexpr std::size_t kLongestName = 120;   // bytes of UTF-8: of a target, a protocol, a person
constexpr std::size_t kLongestNote = 4000;  // bytes: of a note, a reason, a path

enum class Lines { one, many };

/// Why a text cannot be kept, as "contains a control character"; empty if it can. Refused: invalid UTF-8,
/// control characters (line breaks and tabs only in many lines), marks that turn the reading direction, more
/// than `longest` bytes.
std::string faultOfWords(const std::string& text, std::size_t longest, Lines lines = Lines::one);
/// Throws Error unless `name` is a name: not blank, at most kLongestName bytes, one line. `whose`: "the
/// target's name".
void requireName(const std::string& name, const std::string& whose);
/// Throws Error unless `note` can be kept: at most kLongestNote bytes, with line breaks.
void requireNote(const std::string& note, const std::string& whose);

}  // namespace core
}  // namespace facenav
