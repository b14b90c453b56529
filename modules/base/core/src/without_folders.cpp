#include "facenav/core/without_folders.h"

#include <algorithm>
#include <cctype>

namespace facenav {
inline namespace core {
namespace {

constexpr const char *kBlanks = " \t\r\n", *kBeforePath = " \t\r\n'\"([{<>=:,;|";

bool isIn(const char* set, char c) { return std::string(set).find(c) != std::string::npos; }

bool startsAbsolutePath(const std::string& words, std::size_t at) {
  if (words[at] != '/' || at + 1 >= words.size() || isIn(kBlanks, words[at + 1])) return false;
  return at == 0 || isIn(kBeforePath, words[at - 1]);
}

/// True at the start of a clause of an Error: "where: what happened; what to do".
bool startsClause(const std::string& words, std::size_t at) {
  return at >= 2 && isIn(kBlanks, words[at - 1]) && isIn(":;", words[at - 2]);
}

/// True for "3/10", "mm/s", "12/05/2026": each part is a number or has at most three letters.
bool isFraction(const std::string& word) {
  std::size_t begin = 0;
  while (begin <= word.size()) {
    const std::size_t end = std::min(word.find('/', begin), word.size());
    const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
    const bool is_number =
        std::all_of(word.begin() + std::ptrdiff_t(begin), word.begin() + std::ptrdiff_t(end), is_digit);
    if (!is_number && end - begin > 3) return false;
    begin = end + 1;
  }
  return true;
}

/// Removes the text from the first word that is a path to the last '/' of the last one. A folder's name may
/// contain blanks.
std::string withoutRelativeFolders(std::string words) {
  std::size_t first = std::string::npos, after = 0;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find_first_of(kBeforePath, begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    const std::size_t slash = word.rfind('/');
    if (slash != std::string::npos && !isFraction(word)) {
      first = std::min(first, begin);
      after = begin + slash + 1;
    }
    begin = end + 1;
  }
  return first == std::string::npos ? words : words.erase(first, after - first);
}

}  // namespace

std::string withoutFolders(const std::string& words) {
  std::string kept;
  for (std::size_t begin = 0; begin < words.size();) {
    std::size_t end = begin + 1;
    while (end < words.size() && !startsAbsolutePath(words, end) && !startsClause(words, end)) ++end;
    std::string piece = words.substr(begin, end - begin);
    const bool is_absolute = startsAbsolutePath(words, begin);
    const bool is_device = is_absolute && piece.rfind("/dev/", 0) == 0;
    kept += is_device     ? piece
            : is_absolute ? piece.substr(piece.rfind('/') + 1)
                          : withoutRelativeFolders(std::move(piece));
    begin = end;
  }
  return kept;
}

}  // namespace core
}  // namespace facenav
