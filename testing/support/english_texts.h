#pragma once
// Texts of a window in another language that stayed English, and letters that no font has.

#include <QStringList>

class QWidget;

namespace facenav::testing {

/// Texts that `window` shows, or says in tool tips and to screen readers, with an English word in them, each
/// with the widget that has it. Names of programs and formats, units, keys, files and `users_words` are no
/// English words.
QStringList englishTexts(const QWidget& window, const QStringList& users_words);

/// Texts with a letter that neither the widget's font nor those that stand in for it have.
QStringList unreadableTexts(const QWidget& window);

}  // namespace facenav::testing
