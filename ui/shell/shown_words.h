#pragma once
// What the window shows of a module's words: the sentence in the window's language, or the English one where
// the catalogue has none. Names, files and what a person wrote are not for this.

#include <QString>
#include <exception>
#include <memory>
#include <string>

#include "facenav/core/sentence_catalogue.h"

namespace facenav::ui {

/// A module's words as the window shows them. Any thread may ask.
QString shownWords(const std::string& words);
QString shownWords(const QString& words);
/// Why something failed, as the window shows it.
QString shownWords(const std::exception& error);
/// The words of reports that the window makes; null: English. Any thread may ask.
std::shared_ptr<const SentenceCatalogue> reportLanguage();
/// Takes the sentences of a catalogue, the text of a .ts file; empty: English.
void useSentencesOf(const std::string& catalogue);

}  // namespace facenav::ui
