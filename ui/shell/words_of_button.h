#pragma once
// Changes the text of a button, and leaves room for it.

#include <QAbstractButton>
#include <algorithm>

#include "shell/appearance.h"

namespace facenav::ui {

/// Keeps the shortcut, which QAbstractButton::setText would drop. Does nothing if the text is the same.
inline void setWords(QAbstractButton& button, const QString& words) {
  if (button.text() == words) return;
  const QKeySequence key = button.shortcut();
  button.setText(words);
  button.setShortcut(key);
}

/// Leaves room for the longest of these texts, so that its neighbours keep their places. A primary button has
/// bold letters while it can be pressed.
inline void keepWidthOf(const QStringList& texts, QAbstractButton& button) {
  button.ensurePolished();  // the sheet sets the weight
  const auto width_px = [&](const QString& words, int weight) {
    QFont font = button.font();
    font.setWeight(weight);
    return QFontMetrics(font).size(Qt::TextShowMnemonic, words).width();
  };
  const int weight = button.font().weight();
  const int boldest = button.objectName() == "primary" ? std::max<int>(weight, QFont::DemiBold) : weight;
  int longest_px = 0;
  for (const QString& words : texts) longest_px = std::max(longest_px, width_px(words, boldest));
  button.setMinimumWidth(button.sizeHint().width() + longest_px - width_px(button.text(), weight));
}

/// Leaves room for bold letters, which some buttons have when they are chosen.
inline void leaveRoomForBold(QAbstractButton& button) {
  constexpr int kBold_px = 16;
  whenTextScales(&button, [&button] { button.setMinimumWidth(button.sizeHint().width() + kBold_px); });
}

}  // namespace facenav::ui
