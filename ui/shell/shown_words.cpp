#include "shell/shown_words.h"

#include <QHash>
#include <mutex>

#include "facenav/report/report_language.h"

namespace facenav::ui {
namespace {

constexpr int kMostRemembered = 2000;  // texts; those of a live session come again and again

struct Shown {
  std::mutex mutex;
  std::shared_ptr<const SentenceCatalogue> sentences, report;
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
  return *all.remembered.insert(words,
                                QString::fromStdString(all.sentences->translated(words.toStdString())));
}

QString shownWords(const std::string& words) { return shownWords(QString::fromStdString(words)); }

QString shownWords(const std::exception& error) { return shownWords(QString::fromUtf8(error.what())); }

std::shared_ptr<const SentenceCatalogue> reportLanguage() {
  Shown& all = shown();
  const std::lock_guard lock(all.mutex);
  return all.report;
}

void useSentencesOf(const std::string& catalogue) {
  Shown& all = shown();
  const std::lock_guard lock(all.mutex);
  all.sentences = catalogue.empty() ? nullptr
                                    : std::make_shared<const SentenceCatalogue>(
                                          catalogue, std::vector<std::string>{"core"});
  all.report = report::reportSentences(catalogue);
  all.remembered.clear();
}

}  // namespace facenav::ui
