#include "facenav/core/sentence_catalogue.h"

#include <algorithm>
#include <cctype>

#include "ts_messages.h"

namespace facenav {
inline namespace core {
namespace {

constexpr int kDeepest = 3;                      // sentences within values of sentences
constexpr std::size_t kShortest = 2;             // letters of a value that is no sentence
constexpr std::size_t kMostParts = 24;           // of one text; a longer one stays English
constexpr const char* kEdgeMarks = " ,;:.\n";    // as core_sentences.py trims them
constexpr const char* kBeforeBlank = ".,;:";     // ends a part where a blank follows
constexpr const char* kBetweenCaptions = "   ";  // stands between the parts of a caption

using Texts = std::vector<std::string>;

bool startsWith(const std::string& text, std::size_t at, const std::string& what) {
  return text.compare(at, what.size(), what) == 0;
}

bool endsWith(const std::string& text, const std::string& what) {
  return text.size() >= what.size() && startsWith(text, text.size() - what.size(), what);
}

bool isOneOf(char c, const char* all) { return std::string(all).find(c) != std::string::npos; }

/// Length of the separator of two parts that begins at `at`; 0: none begins there.
std::size_t separatorAt(const std::string& words, std::size_t at) {
  const char next = at + 1 < words.size() ? words[at + 1] : '\0';
  if (words[at] == '\n') return 1;
  if ((isOneOf(words[at], kBeforeBlank) && next == ' ') || (words[at] == ' ' && next == '(')) return 2;
  return startsWith(words, at, kBetweenCaptions) ? 3 : 0;
}

/// Where the parts of a text begin.
std::vector<std::size_t> partsOf(const std::string& words) {
  std::vector<std::size_t> starts{0};
  for (std::size_t at = 0; at < words.size();)
    if (const std::size_t length = separatorAt(words, at))
      starts.push_back(at += length);
    else
      ++at;
  return starts;
}

/// A text without what joins it to its neighbours.
struct Trimmed {
  std::string before, text, after;
};

Trimmed trimmed(const std::string& words) {
  std::size_t begin = 0, end = words.size();
  const auto open = [&] {
    const auto first = words.begin() + long(begin), last = words.begin() + long(end);
    return std::count(first, last, '(') - std::count(first, last, ')');
  };
  for (bool has_changed = true; has_changed && begin < end;) {
    const auto balance = open();
    const char first = words[begin], last = words[end - 1];
    if (isOneOf(last, kEdgeMarks) || (last == ')' && balance < 0) || (last == '(' && balance > 0))
      --end;
    else if (isOneOf(first, kEdgeMarks) || (first == '(' && balance > 0) || (first == ')' && balance < 0))
      ++begin;
    else
      has_changed = false;
  }
  return {words.substr(0, begin), words.substr(begin, end - begin), words.substr(end)};
}

/// A text with values: the pieces around them, and the number of each value.
struct Form {
  Texts pieces{{}};
  std::vector<std::size_t> numbers;
};

Form formOf(const std::string& text) {
  Form form;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at + 1;
    while (text[at] == '%' && end < text.size() && std::isdigit(static_cast<unsigned char>(text[end]))) ++end;
    if (end > at + 1) {
      form.numbers.push_back(std::stoul(text.substr(at + 1, end - at - 1)));
      form.pieces.emplace_back();
    } else {
      form.pieces.back() += text[at];
    }
    at = end;
  }
  return form;
}

/// The values between the pieces of a sentence; nothing if the text is another sentence.
std::optional<Texts> valuesIn(const std::string& text, const Texts& pieces) {
  if (!startsWith(text, 0, pieces.front()) || !endsWith(text, pieces.back())) return std::nullopt;
  if (pieces.size() == 1) return text == pieces.front() ? std::optional(Texts()) : std::nullopt;
  Texts values;
  std::size_t at = pieces.front().size();
  const std::size_t end = text.size() - pieces.back().size();
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const std::size_t next = i + 1 == pieces.size() ? end : text.find(pieces[i], at);
    if (next < at || next > end) return std::nullopt;
    values.push_back(text.substr(at, next - at));
    at = next + pieces[i].size();
  }
  return values;
}

/// True for a value that joins parts of a text, or ends where a part ends.
bool hasSeparator(const std::string& value) {
  return partsOf(value).size() > 1 || (!value.empty() && isOneOf(value.back(), kBeforeBlank));
}

/// "FACE NOT SEEN" of "FACE NOT SEEN: turn the head" and of itself; empty for a sentence without such a
/// title.
std::string titleOf(const std::string& source) {
  constexpr std::size_t kShortestTitle = 4;
  const auto end = std::min(source.size(), source.find(": "));
  if (end < kShortestTitle) return {};
  const bool is_title = std::all_of(source.begin(), source.begin() + long(end),
                                    [](char c) { return (c >= 'A' && c <= 'Z') || c == '\'' || c == ' '; });
  return is_title ? source.substr(0, end) : std::string();
}

std::string inSmallLetters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return text;
}

}  // namespace

SentenceCatalogue::SentenceCatalogue(const std::string& ts, const std::vector<std::string>& contexts) {
  const TsFile file = readTs(ts);
  language_ = file.language;
  for (const auto& message : file.messages)
    if (message.is_finished && std::count(contexts.begin(), contexts.end(), message.context)) {
      add(message.source, message.translation);
      addTitle(message.source, message.translation);
      ++read_;
    }
}

void SentenceCatalogue::add(const std::string& source, const std::string& translation) {
  const Form form = formOf(source);
  starting_[form.pieces.front().substr(0, 1)].push_back(sentences_.size());
  sentences_.push_back({form.pieces, translation});
}

/// "FACE NOT SEEN: turn .." is a title with advice; the title is shown alone too, and pulses keep it in small
/// letters.
void SentenceCatalogue::addTitle(const std::string& source, const std::string& translation) {
  const std::string title = titleOf(source);
  const auto end = title == source ? translation.size() : translation.find(": ");
  if (title.empty() || end == std::string::npos) return;
  add(title, translation.substr(0, end));
  add(inSmallLetters(title), translation.substr(0, end));
}

std::string SentenceCatalogue::translated(const std::string& words) const { return best(words, 0).text; }

SentenceCatalogue::Part SentenceCatalogue::best(const std::string& words, int depth) const {
  std::vector<std::size_t> starts = partsOf(words);
  const std::size_t parts = starts.size();
  if (parts > kMostParts) return {words, 0};
  starts.push_back(words.size());
  std::vector<Part> rest(parts + 1);  // best translation from a part to the end
  for (std::size_t from = parts; from-- > 0;) {
    rest[from] = {words.substr(starts[from], starts[from + 1] - starts[from]) + rest[from + 1].text,
                  rest[from + 1].known};
    for (std::size_t to = from + 1; to <= parts; ++to) {
      const auto sentence = one(words.substr(starts[from], starts[to] - starts[from]), depth);
      if (sentence && sentence->known + rest[to].known > rest[from].known)
        rest[from] = {sentence->text + rest[to].text, sentence->known + rest[to].known};
    }
  }
  return rest[0];
}

std::optional<SentenceCatalogue::Part> SentenceCatalogue::one(const std::string& words, int depth) const {
  const Trimmed inside = trimmed(words);
  if (inside.text.empty()) return std::nullopt;
  std::optional<Part> found;
  for (const std::string& first : {inside.text.substr(0, 1), std::string()}) {
    const auto candidates = starting_.find(first);
    if (candidates == starting_.end()) continue;
    for (const std::size_t i : candidates->second) {
      const auto values = valuesIn(inside.text, sentences_[i].pieces);
      if (!values) continue;
      Part part = filled(sentences_[i], *values, depth);
      if (!found || part.known > found->known) found = std::move(part);
    }
  }
  if (found) found->text = inside.before + found->text + inside.after;
  return found;
}

SentenceCatalogue::Part SentenceCatalogue::filled(const Sentence& sentence, const Texts& values,
                                                  int depth) const {
  Part out;
  for (const std::string& piece : sentence.pieces) out.known += int(piece.size());
  Texts shown;
  for (const std::string& value : values) {
    const bool has_words = depth < kDeepest && value.size() > kShortest;
    const Part part = has_words ? best(value, depth + 1) : Part{value, 0};
    // A value with a separator in it is more likely two sentences.
    out.known += part.known - (hasSeparator(value) ? 1 : 0);
    shown.push_back(part.text);
  }
  const Form form = formOf(sentence.translation);
  out.text = form.pieces.front();
  for (std::size_t i = 0; i < form.numbers.size(); ++i) {
    const std::size_t number = form.numbers[i];
    out.text +=
        (number >= 1 && number <= shown.size() ? shown[number - 1] : std::string()) + form.pieces[i + 1];
  }
  return out;
}

}  // namespace core
}  // namespace facenav
