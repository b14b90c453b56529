#include "prepare/distance_legend.h"

#include <QPainter>

#include "facenav/scene/cortex_picture.h"
#include "shell/appearance.h"

namespace facenav::ui {

DistanceLegend::DistanceLegend(QWidget* parent) : QWidget(parent) {
  whenTextScales(this, [this] { setMinimumSize(sized(220), sized(36)); });
  setToolTip(
      tr("distance of the true surface from the phi-theta model: blue lies below it (a sulcus that the "
         "model spans), orange beyond it; the ends of the scale also hold what lies further"));
}

void DistanceLegend::setScale(double full_mm) {
  full_mm_ = full_mm > 0 ? full_mm : 2.0;
  update();
}

void DistanceLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const int margin = sized(34), bar_height = 12, width_px = std::max(1, width() - 2 * margin);
  for (int x = 0; x < width_px; ++x) {
    const auto c = scene::distanceColour((2.0 * x / width_px - 1.0) * full_mm_, full_mm_);
    painter.fillRect(margin + x, 0, 1, bar_height, QColor::fromRgbF(c[0], c[1], c[2]));
  }
  painter.setPen(palette().color(QPalette::WindowText));
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const int x = margin + int((share + 1.0) / 2.0 * width_px);
    painter.drawLine(x, bar_height, x, bar_height + 3);
    const double value = share * full_mm_;
    QString words = QString::number(value, 'f', value == int(value) ? 0 : 1);
    if (value > 0) words.prepend('+');
    if (share == 0.0) words += tr(" mm");  // at the ends it would overlap the next number
    painter.drawText(QRect(x - margin, bar_height + 3, 2 * margin, height() - bar_height - 3),
                     Qt::AlignHCenter, words);
  }
}

}  // namespace facenav::ui
