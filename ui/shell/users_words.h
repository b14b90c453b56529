#pragma once
// Marks widgets whose text a person wrote: names, labels, folders. Such a text may be longer than any window;
// it is then shortened, and the tool tip has the whole.

#include <QVariant>
#include <QWidget>

namespace facenav::ui {

inline void markUsersWords(QWidget& widget) { widget.setProperty("holds_users_words", true); }
inline bool holdsUsersWords(const QWidget& widget) { return widget.property("holds_users_words").toBool(); }

}  // namespace facenav::ui
