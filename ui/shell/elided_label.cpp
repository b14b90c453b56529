#include "shell/elided_label.h"

#include <QPainter>

#include "shell/users_words.h"

namespace facenav::ui {
namespace {

const QString kBetween = QStringLiteral("  \u00b7  ");

}  // namespace

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  // Long text leaves room for the widgets beside it.
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::set(const QString& words) {
  parts_.clear();
  setText(words);
  setToolTip(words);
}

void ElidedLabel::setParts(const QStringList& parts) {
  parts_ = parts;
  setToolTip(parts.join(kBetween));
  fit();
}

void ElidedLabel::fit() {
  if (parts_.isEmpty()) return;
  QStringList shown = parts_;
  const auto isWide = [&] { return fontMetrics().horizontalAdvance(shown.join(kBetween)) > width(); };
  while (shown.size() > 1 && isWide()) shown.removeAt(1);
  if (isWide() && !holdsUsersWords(*this)) shown.clear();
  if (text() != shown.join(kBetween)) setText(shown.join(kBetween));
}

void ElidedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  fit();
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(rect(), Qt::AlignVCenter, fontMetrics().elidedText(text(), Qt::ElideRight, width()));
}

}  // namespace facenav::ui
