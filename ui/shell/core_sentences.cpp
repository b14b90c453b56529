#include "shell/core_sentences.h"

#include <QIODevice>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <algorithm>

namespace facenav::ui {
namespace {

constexpr int kDeepest = 3;        // sentences within values of sentences
constexpr int kShortest = 2;       // letters of a value that is no sentence
constexpr int kMostParts = 24;     // of one text; a longer one stays English
const QString kEdges = " ,;:.\n";  // as core_sentences.py trims them

/// Where a text may be divided. Three blanks stand between the parts of a caption.
const QRegularExpression& separators() {
  static const QRegularExpression kSeparators("[.,;:] |\n| \\(|   ");
  return kSeparators;
}

/// A text without what joins it to its neighbours.
struct Trimmed {
  QString before, text, after;
};

Trimmed trimmed(const QString& words) {
  int begin = 0, end = words.size();
  const auto balance = [&] {
    const QStringRef inside = words.midRef(begin, end - begin);
    return inside.count('(') - inside.count(')');
  };
  for (bool has_changed = true; has_changed && begin < end;) {
    const int open = balance();
    const QChar first = words[begin], last = words[end - 1];
    if (kEdges.contains(last) || (last == ')' && open < 0) || (last == '(' && open > 0))
      --end;
    else if (kEdges.contains(first) || (first == '(' && open > 0) || (first == ')' && open < 0))
      ++begin;
    else
      has_changed = false;
  }
  return {words.left(begin), words.mid(begin, end - begin), words.mid(end)};
}

/// The values between the pieces of a sentence; nothing if the text is another sentence.
std::optional<QStringList> valuesIn(const QString& text, const QStringList& pieces) {
  if (!text.startsWith(pieces.first()) || !text.endsWith(pieces.last())) return std::nullopt;
  QStringList values;
  int at = pieces.first().size();
  const int end = text.size() - pieces.last().size();
  for (int i = 1; i < pieces.size(); ++i) {
    const int next = i + 1 == pieces.size() ? end : text.indexOf(pieces[i], at);
    if (next < at || next > end) return std::nullopt;
    values << text.mid(at, next - at);
    at = next + pieces[i].size();
  }
  return pieces.size() > 1 || text == pieces.first() ? std::optional(values) : std::nullopt;
}

QString firstLetter(const QString& text) { return text.left(1); }

}  // namespace

CoreSentences::CoreSentences(QIODevice& catalogue) {
  QXmlStreamReader xml(&catalogue);
  QString context, source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == "name") context = xml.readElementText();
    if (xml.name() == "source") source = xml.readElementText();
    if (xml.name() != "translation" || context != "core") continue;
    const bool is_finished = !xml.attributes().hasAttribute("type");
    const QString translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
    if (is_finished && !translation.isEmpty()) add(source, translation);
  }
}

void CoreSentences::add(const QString& source, const QString& translation) {
  static const QRegularExpression kValue("%\\d+");
  starting_[firstLetter(source.startsWith('%') ? QString() : source)].push_back(sentences_.size());
  sentences_.push_back({source.split(kValue), translation});
  // "FACE NOT SEEN: turn .." is a title with advice; the title is shown alone too, and pulses keep it in
  // small letters.
  static const QRegularExpression kTitle("^([A-Z' ]{4,}): ");
  const auto title = kTitle.match(source);
  if (!title.hasMatch() || !translation.contains(": ")) return;
  const QString shown = translation.section(": ", 0, 0);
  add(title.captured(1), shown);
  add(title.captured(1).toLower(), shown);
}

QString CoreSentences::translated(const QString& words) const { return best(words, 0).text; }

CoreSentences::Part CoreSentences::best(const QString& words, int depth) const {
  std::vector<int> starts{0};  // of the parts between separators
  for (auto it = separators().globalMatch(words); it.hasNext();) starts.push_back(it.next().capturedEnd());
  const int parts = int(starts.size());
  if (parts > kMostParts) return {words, 0};
  starts.push_back(words.size());
  std::vector<Part> rest(std::size_t(parts) + 1);  // best translation from a part to the end
  for (int from = parts - 1; from >= 0; --from) {
    rest[from] = {words.mid(starts[from], starts[from + 1] - starts[from]) + rest[from + 1].text,
                  rest[from + 1].known};
    for (int to = from + 1; to <= parts; ++to) {
      const auto sentence = one(words.mid(starts[from], starts[to] - starts[from]), depth);
      if (sentence && sentence->known + rest[to].known > rest[from].known)
        rest[from] = {sentence->text + rest[to].text, sentence->known + rest[to].known};
    }
  }
  return rest[0];
}

std::optional<CoreSentences::Part> CoreSentences::one(const QString& words, int depth) const {
  const Trimmed inside = trimmed(words);
  if (inside.text.isEmpty()) return std::nullopt;
  std::optional<Part> found;
  for (const QString& first : {firstLetter(inside.text), QString()}) {
    const auto candidates = starting_.constFind(first);
    if (candidates == starting_.constEnd()) continue;
    for (const std::size_t i : *candidates) {
      const auto values = valuesIn(inside.text, sentences_[i].pieces);
      if (!values) continue;
      const Part part = filled(sentences_[i], *values, depth);
      if (!found || part.known > found->known) found = part;
    }
  }
  if (found) found->text = inside.before + found->text + inside.after;
  return found;
}

CoreSentences::Part CoreSentences::filled(const Sentence& sentence, const QStringList& values,
                                          int depth) const {
  static const QRegularExpression kValue("%(\\d+)");
  Part out;
  for (const QString& piece : sentence.pieces) out.known += piece.size();
  QStringList shown;
  for (const QString& value : values) {
    const bool has_words = depth < kDeepest && value.size() > kShortest;
    const Part part = has_words ? best(value, depth + 1) : Part{value, 0};
    // A value with a separator in it is more likely two sentences.
    out.known += part.known - (value.contains(separators()) ? 1 : 0);
    shown << part.text;
  }
  int done = 0;
  for (auto it = kValue.globalMatch(sentence.translation); it.hasNext();) {
    const auto match = it.next();
    out.text += sentence.translation.mid(done, match.capturedStart() - done) +
                shown.value(match.captured(1).toInt() - 1);
    done = match.capturedEnd();
  }
  out.text += sentence.translation.mid(done);
  return out;
}

}  // namespace facenav::ui
