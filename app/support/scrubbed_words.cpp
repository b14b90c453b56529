#include "support/scrubbed_words.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <vector>

namespace facenav::app {
namespace {

/// Words that tell nobody's name: those of common folders, and the program's own.
const std::set<std::string> kPlainWords{"case",     "cases", "coil",  "data",  "facenav", "home",
                                        "head",     "left",  "local", "media", "mnt",     "right",
                                        "root",     "run",   "share", "test",  "tmp",     "usr",
                                        "sessions", "var",   "work",  "the",   "and",     "figure"};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

/// True for letters and digits, and for every byte of a letter beyond ASCII.
bool isOfWord(unsigned char c) { return std::isalnum(c) || c >= 0x80; }

/// The words of a text that are long enough to tell who somebody is.
std::vector<std::string> wordsOf(const std::string& text) {
  constexpr std::size_t kLeast = 3;
  std::vector<std::string> words;
  std::string word;
  for (const char c : text + " ") {
    if (isOfWord(static_cast<unsigned char>(c))) {
      word += c;
      continue;
    }
    if (word.size() >= kLeast) words.push_back(word);
    word.clear();
  }
  return words;
}

const std::string kInPlace = "[name]";

/// True if a short text stands within a longer word, as "over" in "overlay". A long one is a name there, too.
bool isPartOfAWord(const std::string& text, std::size_t at, std::size_t length) {
  constexpr std::size_t kShort = 5;
  const auto isLetter = [&](std::size_t i) {
    return i < text.size() && isOfWord(static_cast<unsigned char>(text[i]));
  };
  return length <= kShort && ((at > 0 && isLetter(at - 1)) || isLetter(at + length));
}

/// Replaces what stands between quotes, which a person may have typed. A command of facenav stays.
std::string withoutQuoted(const std::string& line) {
  static const std::regex kQuoted(R"((^|[\s(\[=:,])(['"])(?!\.?/?facenav[ .'"-])[^'"\n]*\2)");
  return std::regex_replace(line, kQuoted, "$1$2[words]$2");
}

std::string withoutNumbersOfAddresses(const std::string& line) {
  static const std::regex kIp4(R"(\b\d{1,3}(\.\d{1,3}){3}(:\d+)?\b)"),
      kHex(R"(\b([0-9A-Fa-f]{0,4}:){2,7}[0-9A-Fa-f]{1,4}\b)");
  return std::regex_replace(std::regex_replace(line, kIp4, "[address]"), kHex, "[address]");
}

/// True for "mm/s", "3/10", "and/or": each part is a number or short.
bool isFraction(const std::string& word) {
  static const std::regex kFraction(R"([(\[]?(\d+|[A-Za-z]{1,3})(/(\d+|[A-Za-z]{1,3}))+[)\],.;:]*)");
  return std::regex_match(word, kFraction);
}

/// True if a word of the clause is a path, a file, a host or an address.
bool namesAPlace(const std::string& clause) {
  static const std::regex kFileOrHost(R"([^\s.]+\.[A-Za-z][A-Za-z0-9.-]*\b.*)"), kWord(R"(\S+)");
  for (std::sregex_iterator at(clause.begin(), clause.end(), kWord), end; at != end; ++at) {
    const std::string word = at->str();
    if (word.find_first_of("@\\~") != std::string::npos || word.find("://") != std::string::npos) return true;
    if (word.find('/') != std::string::npos && !isFraction(word)) return true;
    if (std::regex_match(word, kFileOrHost)) return true;
  }
  return false;
}

/// Replaces every clause that names a place by "[path]".
std::string withoutPlaces(const std::string& line) {
  static const std::regex kEnd("[:;] ");
  std::string out;
  auto begin = line.begin();
  for (std::sregex_iterator at(line.begin(), line.end(), kEnd), end; begin != line.end(); ++at) {
    const auto stop = at == end ? line.end() : (*at)[0].first;
    const std::string clause(begin, stop);
    const bool is_place = namesAPlace(clause) && clause.find("'facenav") == std::string::npos;
    out += is_place ? "[path]" : clause;
    if (at == end) break;
    out += at->str();
    begin = (*at)[0].second;
  }
  return out;
}

}  // namespace

void Scrubber::addSecret(const std::string& words) {
  const auto add = [&](const std::string& text) {
    const std::string small = lower(text);
    if (small.size() >= 2 && small.find_first_not_of(" 0123456789.-") != std::string::npos &&
        !kPlainWords.count(small))
      secrets_.insert(small);
  };
  for (const std::string& word : wordsOf(words)) add(word);
  add(words);
}

std::string Scrubber::withoutSecrets(const std::string& text) const {
  std::vector<std::string> longest_first(secrets_.begin(), secrets_.end());
  std::sort(longest_first.begin(), longest_first.end(),
            [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
  std::string out = text;
  for (const std::string& secret : longest_first)
    for (std::size_t at = lower(out).find(secret); at != std::string::npos;
         at = lower(out).find(secret, at + 1)) {
      if (isPartOfAWord(out, at, secret.size())) continue;
      out.replace(at, secret.size(), kInPlace);
      at += kInPlace.size() - 1;
    }
  return out;
}

std::string Scrubber::scrubbed(const std::string& line) const {
  return withoutSecrets(withoutNumbersOfAddresses(withoutPlaces(withoutQuoted(line))));
}

}  // namespace facenav::app
