#pragma once
// A label that wraps its text and never widens its container.

#include <QLabel>
#include <algorithm>

#include "shell/appearance.h"

namespace facenav::ui {

/// Height of a line of usual text, as sized() takes it: for labels that keep room for some lines.
constexpr int kTextLine_px = 17;

inline void makeNarrow(QLabel& label) {
  label.setWordWrap(true);
  QSizePolicy policy = label.sizePolicy();  // keeps height-for-width
  policy.setHorizontalPolicy(QSizePolicy::Ignored);
  label.setSizePolicy(policy);
}

/// Keeps the height of the label's lines in a column that is short of room, as it is with large text. With
/// usual text the column has that room, and the lists in it need every line.
inline void keepLines(QLabel& label) {
  constexpr double kLarge = 1.25;
  label.setMinimumHeight(textScale() > kLarge ? std::max(0, label.heightForWidth(label.width())) : 0);
}

}  // namespace facenav::ui
