#include "shell/shown_words.h"

#include <QHash>
#include <memory>
#include <mutex>

#include "shell/core_sentences.h"

namespace facenav::ui {
namespace {

constexpr int kMostRemembered = 2000;  // texts; those of a live session come again and again

struct Shown {
  std::mutex mutex;
  std::unique_ptr<CoreSentences> sentences;
  QHash<QString, QString> remembered;
};

Shown& shown() {
  static Shown all;
  return all;
}

}  // namespace

QString shownWords(const QString& words) {
  Shown& all = shown();
  const std::lock_guard lock(all.mutex);
  if (!all.sentences || words.isEmpty()) return words;
  if (const auto known = all.remembered.constFind(words); known != all.remembered.constEnd()) return *known;
  if (all.remembered.size() >= kMostRemembered) all.remembered.clear();
  return *all.remembered.insert(words, all.sentences->translated(words));
}

QString shownWords(const std::string& words) { return shownWords(QString::fromStdString(words)); }

QString shownWords(const std::exception& error) { return shownWords(QString::fromUtf8(error.what())); }

void useSentencesOf(QIODevice* catalogue) {
  Shown& all = shown();
  const std::lock_guard lock(all.mutex);
  all.sentences = catalogue ? std::make_unique<CoreSentences>(*catalogue) : nullptr;
  all.remembered.clear();
}

}  // namespace facenav::ui
