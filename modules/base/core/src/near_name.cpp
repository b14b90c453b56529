#include "facenav/core/near_name.h"

#include <algorithm>

namespace facenav {
inline namespace core {
namespace {

constexpr std::size_t kLeastBeginning = 3;  // fewest letters that identify a name by its beginning

/// Greatest number of wrong letters in a word of this length.
std::size_t allowedLetters(std::size_t length) { return length <= 4 ? 1 : length <= 8 ? 2 : 3; }

bool isBeginning(const std::string& word, const std::string& name) {
  return word.size() >= kLeastBeginning && name.compare(0, word.size(), word) == 0;
}

}  // namespace

std::size_t lettersApart(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = last;
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row.back();
}

std::optional<std::string> nearName(const std::string& word, const std::vector<std::string>& names) {
  std::optional<std::string> nearest;
  std::size_t least = allowedLetters(word.size()) + 1;
  for (const std::string& name : names) {
    const std::size_t apart = isBeginning(word, name) ? 1 : lettersApart(word, name);
    if (apart >= least) continue;
    least = apart;
    nearest = name;
  }
  return nearest;
}

}  // namespace core
}  // namespace facenav
