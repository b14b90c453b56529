#include "shell/status_chip.h"

#include <QPainter>
#include <algorithm>

#include "shell/theme.h"

namespace facenav::ui {

QColor colourOf(Level level) {
  switch (level) {
    case Level::good:
      return themeColour(Colour::good);
    case Level::caution:
      return themeColour(Colour::caution);
    case Level::lost:
    case Level::idle:
      break;
  }
  return themeColour(Colour::lost);
}

StatusChip::StatusChip(const QString& longest, QWidget* parent) : QWidget(parent), longest_(longest) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void StatusChip::set(const Chip& chip) {
  if (chip.words == chip_.words && chip.level == chip_.level && chip.tip == chip_.tip) return;
  chip_ = chip;
  setToolTip(chip.tip);
  setAccessibleName(chip.words);
  updateGeometry();
  update();
}

QSize StatusChip::sizeHint() const {
  const QFontMetrics metrics = fontMetrics();
  return {std::max(metrics.horizontalAdvance(chip_.words), metrics.horizontalAdvance(longest_)) + 44,
          fontMetrics().height() + 12};
}

void StatusChip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour = colourOf(chip_.level);
  painter.setPen(QPen(colour, 1.2));
  painter.setBrush(themeColour(Colour::chip));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), height() / 2.0, height() / 2.0);
  const QPointF c(18, height() / 2.0);
  const double r = 5.5;
  if (chip_.level == Level::good) {
    painter.setBrush(colour);
    painter.drawEllipse(c, r, r);
  } else if (chip_.level == Level::caution) {
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF({c + QPointF(0, -r), c + QPointF(r, r), c + QPointF(-r, r)}));
  } else if (chip_.level == Level::idle) {
    painter.setPen(QPen(colour, 2.0));
    painter.drawEllipse(c, r, r);
  } else {
    painter.setPen(QPen(colour, 2.4));
    painter.drawLine(c + QPointF(-r, -r), c + QPointF(r, r));
    painter.drawLine(c + QPointF(-r, r), c + QPointF(r, -r));
  }
  painter.setPen(themeColour(Colour::text));
  painter.drawText(rect().adjusted(32, 0, -8, 0), Qt::AlignVCenter | Qt::AlignLeft, chip_.words);
}

}  // namespace facenav::ui
