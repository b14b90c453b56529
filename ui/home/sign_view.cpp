#include "home/sign_view.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "shell/appearance.h"
#include "shell/theme.h"

namespace facenav::ui {
namespace {

using steps::HomeSign;

/// Arrow that points up, in a square of -50 .. 50.
QPolygonF arrowShape() {
  return QPolygonF({{0, -46}, {30, -12}, {12, -12}, {12, 44}, {-12, 44}, {-12, -12}, {-30, -12}});
}

void drawTurn(QPainter& painter, bool is_clockwise) {
  painter.save();
  if (!is_clockwise) painter.scale(-1, 1);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(themeColour(Colour::now), 12, Qt::SolidLine, Qt::FlatCap));
  painter.drawArc(QRectF(-36, -36, 72, 72), 200 * 16, -250 * 16);
  painter.setPen(Qt::NoPen);
  painter.setBrush(themeColour(Colour::now));
  painter.rotate(-50 + 90 + 90);
  painter.translate(0, -36);
  painter.drawPolygon(QPolygonF({{-2, -18}, {26, 0}, {-2, 18}}));
  painter.restore();
}

void drawTick(QPainter& painter) {
  QPainterPath tick(QPointF(-34, 2));
  tick.lineTo(-10, 28);
  tick.lineTo(36, -28);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(themeColour(Colour::good), 14, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(tick);
}

void drawStop(QPainter& painter) {
  QPolygonF octagon;
  for (int i = 0; i < 8; ++i) {
    const double angle = (i + 0.5) * M_PI / 4;
    octagon << QPointF(44 * std::cos(angle), 44 * std::sin(angle));
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(themeColour(Colour::stop));
  painter.drawPolygon(octagon);
  painter.setBrush(themeColour(Colour::on_accent));
  painter.drawRect(QRectF(-26, -6, 52, 12));
}

/// Draws the motion towards or away from the head in side view; the line below is the head.
void drawLift(QPainter& painter, bool is_up) {
  painter.setPen(QPen(themeColour(Colour::sign_quiet), 8, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(-40, 44), QPointF(40, 44));
  painter.save();
  painter.setPen(Qt::NoPen);
  painter.setBrush(themeColour(Colour::now));
  painter.translate(0, -6);
  painter.scale(0.85, is_up ? 0.85 : -0.85);
  painter.drawPolygon(arrowShape());
  painter.restore();
}

/// Draws a small arrow at the side that must rise.
void drawRaised(QPainter& painter, const QPointF& at) {
  painter.save();
  painter.translate(at);
  painter.setPen(QPen(themeColour(Colour::on_state), 2));
  painter.setBrush(themeColour(Colour::now));
  painter.drawEllipse(QPointF(0, 0), 19, 19);
  painter.setPen(Qt::NoPen);
  painter.setBrush(themeColour(Colour::on_state));
  painter.scale(0.3, 0.3);
  painter.drawPolygon(arrowShape());
  painter.restore();
}

}  // namespace

SignView::SignView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(160, 140);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void SignView::set(HomeSign sign, double arrow_rad, bool is_refused) {
  if (sign == sign_ && arrow_rad == arrow_rad_ && is_refused == is_refused_) return;
  sign_ = sign;
  arrow_rad_ = arrow_rad;
  is_refused_ = is_refused;
  update();
}

/// Draws the coil faintly, two wings and the handle below, for signs that refer to its sides.
void SignView::drawCoil(QPainter& painter) const {
  painter.setPen(QPen(themeColour(Colour::sign_quiet), 5));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(QPointF(-22, -6), 22, 22);
  painter.drawEllipse(QPointF(22, -6), 22, 22);
  painter.drawLine(QPointF(0, 14), QPointF(0, 48));
}

void SignView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(width() / 2.0, height() / 2.0);
  const double scale = std::min(width(), height()) / 108.0;
  painter.scale(scale, scale);
  if (is_refused_) return drawStop(painter);
  switch (sign_) {
    case HomeSign::none:
      return;
    case HomeSign::arrow:
      drawCoil(painter);
      painter.rotate(arrow_rad_ * 180 / M_PI);
      painter.setPen(QPen(themeColour(Colour::on_state), 2));
      painter.setBrush(themeColour(Colour::now));
      painter.drawPolygon(arrowShape());
      return;
    case HomeSign::lift:
    case HomeSign::press:
      return drawLift(painter, sign_ == HomeSign::lift);
    case HomeSign::turn_clockwise:
    case HomeSign::turn_counterclockwise:
      drawCoil(painter);
      return drawTurn(painter, sign_ == HomeSign::turn_clockwise);
    case HomeSign::raise_left:
      drawCoil(painter);
      return drawRaised(painter, {-34, -6});
    case HomeSign::raise_right:
      drawCoil(painter);
      return drawRaised(painter, {34, -6});
    case HomeSign::raise_handle:
      drawCoil(painter);
      return drawRaised(painter, {0, 34});
    case HomeSign::raise_front:
      drawCoil(painter);
      return drawRaised(painter, {0, -34});
    case HomeSign::hold:
      return drawTick(painter);
  }
}

}  // namespace facenav::ui
