#pragma once
// Sentences of the modules in the window's language. The modules compose English sentences with values in
// them. A catalogue (resources/languages/facenav_*.ts, context "core") holds each sentence with %1, %2 .. for
// its values; resources/languages/core_sentences.py lists them from the sources.

#include <QHash>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

class QIODevice;

namespace facenav::ui {

class CoreSentences {
 public:
  /// Reads the finished sentences of a .ts file.
  explicit CoreSentences(QIODevice& catalogue);
  std::size_t count() const { return sentences_.size(); }
  /// Translates each sentence of `words` that the catalogue has, with the sentences among its values. The
  /// rest stays as it is.
  QString translated(const QString& words) const;

 private:
  struct Sentence {
    QStringList pieces;   // the English text between its values
    QString translation;  // %1, %2 .. for the values
  };
  struct Part {
    QString text;
    int known = 0;  // letters of the English text that the catalogue has
  };

  void add(const QString& source, const QString& translation);
  /// The best translation of a text of one or several sentences. `depth`: how many values it lies in.
  Part best(const QString& words, int depth) const;
  /// The best translation of a text as one sentence; nothing if it is none.
  std::optional<Part> one(const QString& words, int depth) const;
  Part filled(const Sentence& sentence, const QStringList& values, int depth) const;

  std::vector<Sentence> sentences_;
  QHash<QString, std::vector<std::size_t>> starting_;  // indices into sentences_, by the first letter
};

}  // namespace facenav::ui
