#include "shell/elided_label.h"

#include <QPainter>

namespace facenav::ui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  // Long text leaves room for the widgets beside it.
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::set(const QString& words) {
  setText(words);
  setToolTip(words);
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(rect(), Qt::AlignVCenter, fontMetrics().elidedText(text(), Qt::ElideRight, width()));
}

}  // namespace facenav::ui
