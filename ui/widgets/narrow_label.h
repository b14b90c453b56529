#pragma once
// Words that wrap, and never widen what they stand in.

#include <QLabel>

namespace facenav::ui {

inline void makeNarrow(QLabel& label) {
  label.setWordWrap(true);
  QSizePolicy policy = label.sizePolicy();  // keeps its height for a width
  policy.setHorizontalPolicy(QSizePolicy::Ignored);
  label.setSizePolicy(policy);
}

}  // namespace facenav::ui
