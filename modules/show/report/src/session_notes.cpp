#include "facenav/report/session_notes.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/plain_words.h"

namespace facenav::report {

std::string painWords(double pain) {
  if (!(pain >= 0 && pain <= 10))
    throw Error("the pain is given as 0 to 10", formatted("%g", pain), "0: none, 10: the worst imaginable");
  return formatted("%g", pain);
}

std::string noteWords(const std::string& words, const std::string& what) {
  requireNote(words, "the note");
  std::string line = words;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  const auto first = line.find_first_not_of(' ');
  if (first == std::string::npos) throw Error("nothing was written", what, "describe it in some words");
  return line.substr(first, line.find_last_not_of(' ') - first + 1);
}

}  // namespace facenav::report
