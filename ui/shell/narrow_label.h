#pragma once
// A label that wraps its text and never widens its container.

#include <QLabel>

namespace facenav::ui {

/// Height of a line of usual text, as sized() takes it: for labels that keep room for some lines.
constexpr int kTextLine_px = 17;

inline void makeNarrow(QLabel& label) {
  label.setWordWrap(true);
  QSizePolicy policy = label.sizePolicy();  // keeps height-for-width
  policy.setHorizontalPolicy(QSizePolicy::Ignored);
  label.setSizePolicy(policy);
}

/// Makes the height that the label's lines need at its width its least height: a column that is short of room
/// gives less than that.
inline void keepLines(QLabel& label) {
  const int needed_px = label.heightForWidth(label.width());
  if (needed_px >= 0) label.setMinimumHeight(needed_px);
}

}  // namespace facenav::ui
