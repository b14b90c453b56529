#pragma once
// Finds the name that a mistyped word was meant to be: a setting, a verb of the command line.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace facenav {
inline namespace core {

/// Counts the letters to insert, remove, replace or swap with their neighbour to turn one word into the other
/// (Damerau 1964, Levenshtein 1966; each pair is swapped at most once).
std::size_t lettersApart(const std::string& a, const std::string& b);

/// The name that `word` is most likely a misspelling or the beginning of; none if no name is near: more than
/// one letter off in up to four, two in up to eight, three in longer words. The first of equally near names.
std::optional<std::string> nearName(const std::string& word, const std::vector<std::string>& names);

}  // namespace core
}  // namespace facenav
