#include "home/fitted_words.h"

#include <QPainter>

#include "shell/appearance.h"

namespace facenav::ui {
namespace {

constexpr double kSmallest_pt = 9, kShrink = 0.92;

}  // namespace

FittedWords::FittedWords(double largest_pt, QWidget* parent) : QWidget(parent), largest_pt_(largest_pt) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void FittedWords::set(const QString& words, const QColor& colour) {
  if (words == words_ && colour == colour_) return;
  words_ = words;
  colour_ = colour;
  setAccessibleName(words);
  update();
}

QSize FittedWords::sizeHint() const { return {sized(400), sized(90)}; }
QSize FittedWords::minimumSizeHint() const { return {120, 40}; }

void FittedWords::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(colour_);
  QFont shown = font();
  const int how = Qt::AlignCenter | Qt::TextWordWrap;
  for (double pt = largest_pt_ * textScale();; pt *= kShrink) {
    shown.setPointSizeF(pt);
    const QRect needed = QFontMetrics(shown).boundingRect(rect(), how, words_);
    if (pt <= kSmallest_pt || (needed.width() <= width() && needed.height() <= height())) break;
  }
  painter.setFont(shown);
  painter.drawText(rect(), how, words_);
}

}  // namespace facenav::ui
