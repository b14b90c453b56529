#pragma once
// What the window shows of a module's words: the sentence in the window's language, or the English one where
// the catalogue has none. Names, files and what a person wrote are not for this.

#include <QString>
#include <exception>
#include <string>

class QIODevice;

namespace facenav::ui {

/// A module's words as the window shows them. Any thread may ask.
QString shownWords(const std::string& words);
QString shownWords(const QString& words);
/// Why something failed, as the window shows it.
QString shownWords(const std::exception& error);
/// Takes the sentences of a catalogue (.ts); null: English.
void useSentencesOf(QIODevice* catalogue);

}  // namespace facenav::ui
