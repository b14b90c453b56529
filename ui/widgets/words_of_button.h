#pragma once
// Changes the words on a button.

#include <QAbstractButton>

namespace facenav::ui {

/// QAbstractButton::setText drops the button's shortcut; here it stays. Nothing happens where the words are
/// the same.
inline void setWords(QAbstractButton& button, const QString& words) {
  if (button.text() == words) return;
  const QKeySequence key = button.shortcut();
  button.setText(words);
  button.setShortcut(key);
}

}  // namespace facenav::ui
