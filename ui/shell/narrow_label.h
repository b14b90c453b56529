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

}  // namespace facenav::ui
