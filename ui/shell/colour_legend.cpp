#include "shell/colour_legend.h"

#include <QPainter>

#include "shell/appearance.h"

namespace facenav::ui {

ColourLegend::ColourLegend(QWidget* parent) : QWidget(parent) {
  whenTextScales(this, [this] { setMinimumSize(sized(150), sized(38)); });
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(tr("colour of the pulses: dark is the least value, bright the largest; grey: not known"));
}

void ColourLegend::set(const QString& words, const QString& unit, int decimals,
                       std::optional<scene::ColourRange> range) {
  words_ = words;
  unit_ = unit;
  decimals_ = decimals;
  range_ = range;
  update();
}

QString ColourLegend::words() const {
  if (!range_) return words_;
  return tr("%1 %2 to %3 %4")
      .arg(words_)
      .arg(range_->low, 0, 'f', decimals_)
      .arg(range_->high, 0, 'f', decimals_)
      .arg(unit_);
}

void ColourLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::WindowText));
  if (!range_) return painter.drawText(rect(), Qt::AlignVCenter | Qt::AlignLeft, words_);
  const int bar_height = sized(12), width_px = std::max(1, width());
  for (int x = 0; x < width_px; ++x) {
    const auto c = scene::sequentialColour(double(x) / width_px);
    painter.fillRect(x, 0, 1, bar_height, QColor::fromRgbF(c[0], c[1], c[2]));
  }
  const QRect below = rect().adjusted(0, bar_height + 2, 0, 0);
  painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, QString::number(range_->low, 'f', decimals_));
  painter.drawText(below, Qt::AlignHCenter | Qt::AlignTop, words_ + " (" + unit_ + ")");
  painter.drawText(below, Qt::AlignRight | Qt::AlignTop, QString::number(range_->high, 'f', decimals_));
}

}  // namespace facenav::ui
