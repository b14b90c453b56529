#pragma once
// The frame of a picture that has the focus: white on the picture's black.

#include <QPainter>
#include <QWidget>

#include "shell/theme.h"

namespace facenav::ui {

constexpr int kFocusFrame_px = 2;

/// Paints the frame if the view has the focus.
inline void paintFocus(QPainter& painter, const QWidget& view) {
  if (!view.hasFocus()) return;
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(themeColour(Colour::picture_text), kFocusFrame_px));
  painter.drawRect(view.rect().adjusted(1, 1, -1, -1));
}

}  // namespace facenav::ui
