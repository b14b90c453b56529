#pragma once
// Changes the text of a button.

#include <QAbstractButton>

namespace facenav::ui {

/// Keeps the shortcut, which QAbstractButton::setText would drop. Does nothing if the text is the same.
inline void setWords(QAbstractButton& button, const QString& words) {
  if (button.text() == words) return;
  const QKeySequence key = button.shortcut();
  button.setText(words);
  button.setShortcut(key);
}

}  // namespace facenav::ui
