#include "home/fitted_words.h"

#include <QPainter>

#include "shell/appearance.h"

namespace facenav::ui {
namespace {

constexpr double kSmallest_pt = 9, kShrink = 0.92;
constexpr int kHow = Qt::AlignCenter | Qt::TextWordWrap;

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

/// The text's largest font that fits, or the smallest one there is.
QFont FittedWords::fittedFont() const {
  QFont shown = font();
  for (double pt = largest_pt_ * textScale();; pt *= kShrink) {
    shown.setPointSizeF(pt);
    if (pt <= kSmallest_pt || fits(shown)) return shown;
  }
}

bool FittedWords::fits(const QFont& shown) const {
  const QRect needed = QFontMetrics(shown).boundingRect(rect(), kHow, words_);
  return needed.width() <= width() && needed.height() <= height();
}

bool FittedWords::isWhole() const { return words_.isEmpty() || fits(fittedFont()); }

void FittedWords::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(colour_);
  painter.setFont(fittedFont());
  painter.drawText(rect(), kHow, words_);
}

}  // namespace facenav::ui
