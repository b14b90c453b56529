#pragma once
// Sentences of the modules in another language. The modules compose English sentences with values in them. A
// catalogue (resources/languages/facenav_*.ts, Qt Linguist's format) holds each sentence with %1, %2 .. for
// its values; resources/languages/core_sentences.py lists them from the sources. Text is UTF-8.

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace facenav {
inline namespace core {

class SentenceCatalogue {
 public:
  /// Reads the finished sentences of some contexts. `ts`: the text of a .ts file.
  SentenceCatalogue(const std::string& ts, const std::vector<std::string>& contexts);
  /// Code of the language, "ja".
  const std::string& language() const { return language_; }
  std::size_t count() const { return read_; }
  /// Translates each sentence of `words` that the catalogue has, with the sentences among its values. The
  /// rest stays as it is.
  std::string translated(const std::string& words) const;

 private:
  struct Sentence {
    std::vector<std::string> pieces;  // the English text between its values
    std::string translation;          // %1, %2 .. for the values
  };
  struct Part {
    std::string text;
    int known = 0;  // letters of the English text that the catalogue has
  };

  void add(const std::string& source, const std::string& translation);
  void addTitle(const std::string& source, const std::string& translation);
  /// The best translation of a text of one or several sentences. `depth`: how many values it lies in.
  Part best(const std::string& words, int depth) const;
  /// The best translation of a text as one sentence; nothing if it is none.
  std::optional<Part> one(const std::string& words, int depth) const;
  Part filled(const Sentence& sentence, const std::vector<std::string>& values, int depth) const;

  std::string language_;
  std::size_t read_ = 0;
  std::vector<Sentence> sentences_;
  std::unordered_map<std::string, std::vector<std::size_t>>
      starting_;  // into sentences_, by the first letter
};

}  // namespace core
}  // namespace facenav
