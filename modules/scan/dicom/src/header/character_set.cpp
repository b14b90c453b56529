#include "facenav/dicom/character_set.h"

#include <iconv.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace facenav::dicom {
namespace {

constexpr char kEscape = '\x1B';

bool isUtf8(std::string_view s) {
  for (std::size_t i = 0; i < s.size();) {
    const unsigned char c = s[i];
    const int more = c < 0x80 ? 0 : c >> 5 == 6 ? 1 : c >> 4 == 14 ? 2 : c >> 3 == 30 ? 3 : -1;
    if (more < 0 || i + more >= s.size() + (more == 0)) return false;
    for (int k = 1; k <= more; ++k)
      if ((static_cast<unsigned char>(s[i + k]) & 0xC0) != 0x80) return false;
    i += 1 + more;
  }
  return true;
}

bool contains(std::string_view text, std::string_view word) {
  return text.find(word) != std::string_view::npos;
}

/// Encoding by the set's registration number ("ISO_IR 144", "ISO 2022 IR 144"), from the first value, which
/// applies without escape sequences.
const char* withoutEscapes(std::string_view character_set) {
  const std::string_view first = character_set.substr(0, character_set.find('\\'));
  if (contains(first, "GB18030")) return "GB18030";
  if (contains(first, "GBK")) return "GBK";
  const std::pair<std::string_view, const char*> known[] = {
      {"100", "ISO-8859-1"}, {"101", "ISO-8859-2"},  {"109", "ISO-8859-3"}, {"110", "ISO-8859-4"},
      {"144", "ISO-8859-5"}, {"127", "ISO-8859-6"},  {"126", "ISO-8859-7"}, {"138", "ISO-8859-8"},
      {"148", "ISO-8859-9"}, {"203", "ISO-8859-15"}, {"166", "TIS-620"},    {"13", "SHIFT_JIS"}};
  const std::size_t number = first.find("IR ");
  if (number == std::string_view::npos) return nullptr;
  std::string_view registered = first.substr(number + 3);
  registered = registered.substr(0, registered.find(' '));
  for (const auto& [name, encoding] : known)
    if (registered == name) return encoding;
  return nullptr;
}

const char* withEscapes(std::string_view character_set) {
  if (contains(character_set, "IR 87") || contains(character_set, "IR 159")) return "ISO-2022-JP-2";
  if (contains(character_set, "IR 149")) return "EUC-KR";
  if (contains(character_set, "IR 58")) return "GB2312";
  return nullptr;
}

/// Removes the escape sequences around Korean and Chinese, which lie in bytes above 127: "ESC $ ) C" and
/// "ESC $ ) A" announce them, "ESC ( B" and the like name the set of the bytes below (PS3.3 C.12.1.1.2).
std::string withoutDesignations(std::string_view raw) {
  constexpr std::size_t kTwoBytes = 4, kOneByte = 3;  // lengths of the sequences
  std::string text;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const std::string_view next = raw.substr(i + 1, 2);
    if (raw[i] == kEscape && (next == "$)" || next == "$("))
      i += kTwoBytes - 1;
    else if (raw[i] == kEscape && !next.empty() && (next[0] == '(' || next[0] == ')' || next[0] == '-'))
      i += kOneByte - 1;
    else
      text += raw[i];
  }
  return text;
}

bool isEuc(const char* encoding) {
  return std::string_view(encoding) == "EUC-KR" || std::string_view(encoding) == "GB2312";
}

/// Converts `text` to UTF-8; nullopt if it is not valid in `encoding`.
std::optional<std::string> convert(std::string text, const char* encoding) {
  const iconv_t converter = ::iconv_open("UTF-8", encoding);
  if (converter == iconv_t(-1)) return std::nullopt;
  std::string utf8(4 * text.size() + 8, '\0');
  char *in = text.data(), *out = utf8.data();
  std::size_t in_left = text.size(), out_left = utf8.size();
  const bool is_converted = ::iconv(converter, &in, &in_left, &out, &out_left) != std::size_t(-1) &&
                            ::iconv(converter, nullptr, nullptr, &out, &out_left) != std::size_t(-1);
  ::iconv_close(converter);
  if (!is_converted || in_left > 0) return std::nullopt;
  utf8.resize(utf8.size() - out_left);
  return utf8;
}

std::string fromLatin1(std::string_view raw) {
  std::string text;
  for (const char c : raw) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += char(0xC0 | byte >> 6);
      text += char(0x80 | (byte & 0x3F));
    }
  }
  return text;
}

}  // namespace

std::string toUtf8(std::string_view raw, std::string_view character_set) {
  const bool has_escapes = raw.find(kEscape) != std::string_view::npos;
  if (!has_escapes && isUtf8(raw))
    return std::string(raw);  // also if the file declares Latin-1: a common error
  if (const char* encoding = has_escapes ? withEscapes(character_set) : withoutEscapes(character_set))
    if (auto text =
            convert(has_escapes && isEuc(encoding) ? withoutDesignations(raw) : std::string(raw), encoding))
      return *text;
  return fromLatin1(raw);
}

std::string onOneLine(std::string text) {
  constexpr unsigned char kLastControl = 0x1F, kDelete = 0x7F;
  for (char& c : text)
    if (static_cast<unsigned char>(c) <= kLastControl || static_cast<unsigned char>(c) == kDelete) c = ' ';
  return text;
}

std::string personNameToUtf8(std::string_view raw, std::string_view character_set) {
  while (!raw.empty() && raw.front() == '=') raw.remove_prefix(1);
  // Cut before decoding: the alphabetic group is the one without escape sequences. In the other groups "="
  // may be half of a character.
  if (const std::size_t end = raw.find('='); raw.substr(0, end).find(kEscape) == std::string_view::npos)
    raw = raw.substr(0, end);
  const std::string name = onOneLine(toUtf8(raw, character_set));
  return name.substr(0, name.find('='));
}

}  // namespace facenav::dicom
