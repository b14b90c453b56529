#include "treat/guidance_screen.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "facenav/geometry/rotation.h"
#include "shell/status_chip.h"
#include "shell/theme.h"

namespace facenav::ui {
namespace {

/// One word for the step; if lost: the title of the loss.
QString wordFor(guidance::Action action, const ReadOut& read_out) {
  if (read_out.level == Level::lost || read_out.level == Level::idle)
    return read_out.instruction.section(':', 0, 0);
  switch (action) {
    case guidance::Action::move:
      return GuidanceScreen::tr("MOVE");
    case guidance::Action::lift:
      return GuidanceScreen::tr("LIFT");
    case guidance::Action::press:
      return GuidanceScreen::tr("PRESS");
    case guidance::Action::tilt:
      return GuidanceScreen::tr("TILT");
    case guidance::Action::turn:
      return GuidanceScreen::tr("TURN");
    case guidance::Action::hold:
      return GuidanceScreen::tr("HOLD");
    default:  // the alignment is too uncertain to be on target
      return GuidanceScreen::tr("ALIGN AGAIN");
  }
}

/// The figure that this step reduces.
QString figureFor(guidance::Action action, const guidance::GuidanceValues& values) {
  const auto mm = [](double value) { return GuidanceScreen::tr("%1 mm").arg(std::abs(value), 0, 'f', 1); };
  const auto degrees = [](double rad) {
    return QString::number(std::lround(std::abs(rad) * kDegPerRad)) + QChar(0x00b0);
  };
  switch (action) {
    case guidance::Action::lift:
    case guidance::Action::press:
      return mm(values.depth_mm);
    case guidance::Action::tilt:
      return degrees(values.tilt_rad);
    case guidance::Action::turn:
      return degrees(values.twist_rad);
    default:
      return mm(values.lateral_mm);
  }
}

/// Angle on the screen: right is the coil's -x, up its +y, as on the bull's eye.
double onScreen_rad(const Eigen::Vector2d& in_coil) { return std::atan2(in_coil.y(), -in_coil.x()); }

QFont letters(const QWidget& widget, double height_px, int weight = QFont::Bold) {
  QFont font = widget.font();
  font.setPixelSize(std::max(1, int(height_px)));
  font.setWeight(weight);
  return font;
}

/// Largest font with which the words fit in one line, at most `height_px`.
QFont lettersIn(const QWidget& widget, const QString& words, double height_px, double width_px) {
  QFont font = letters(widget, height_px);
  const double needed_px = QFontMetricsF(font).horizontalAdvance(words);
  if (needed_px > width_px) font.setPixelSize(std::max(1, int(height_px * width_px / needed_px)));
  return font;
}

/// Arrow from the middle outwards along +x, of length 1.
QPainterPath arrowPath() {
  QPainterPath path;
  path.moveTo(-0.75, -0.16);
  path.lineTo(0.15, -0.16);
  path.lineTo(0.15, -0.48);
  path.lineTo(0.85, 0);
  path.lineTo(0.15, 0.48);
  path.lineTo(0.15, 0.16);
  path.lineTo(-0.75, 0.16);
  path.closeSubpath();
  return path;
}

void drawArrow(QPainter& painter, double angle_rad, const QColor& colour) {
  painter.save();
  painter.rotate(-angle_rad * kDegPerRad);
  painter.fillPath(arrowPath(), colour);
  painter.restore();
}

/// Draws the plate from the side on a curved head, and the motion along its axis.
void drawLift(QPainter& painter, bool is_up, const QColor& colour) {
  painter.setPen(QPen(themeColour(Colour::muted), 0.07, Qt::SolidLine, Qt::RoundCap));
  painter.drawArc(QRectF(-1.1, 0.45, 2.2, 2.2), 30 * 16, 120 * 16);
  painter.save();
  painter.translate(0, -0.25);
  painter.scale(0.8, 0.8);
  drawArrow(painter, is_up ? M_PI / 2 : -M_PI / 2, colour);
  painter.restore();
}

/// Draws the tilted plate, the level to reach, and the motion of its left end: the left wing, or (with a
/// knob) the handle.
void drawTilt(QPainter& painter, bool is_left_up, bool is_handle, const QColor& colour) {
  const double low = is_left_up ? 0.38 : -0.38;  // height of the left end; y is down
  painter.setPen(QPen(themeColour(Colour::muted), 0.06, Qt::DashLine));
  painter.drawLine(QPointF(-0.85, 0), QPointF(0.85, 0));
  painter.setPen(QPen(colour, 0.16, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(-0.6, low), QPointF(0.75, -low));
  if (is_handle) {
    painter.setBrush(colour);
    painter.drawEllipse(QPointF(-0.66, low * 1.05), 0.1, 0.1);
  }
  painter.save();
  painter.translate(-0.62, is_left_up ? -0.12 : 0.12);
  painter.scale(0.34, 0.34);
  drawArrow(painter, is_left_up ? M_PI / 2 : -M_PI / 2, colour);
  painter.restore();
}

/// Draws an open circle with an arrow head: the direction in which the handle turns.
void drawTurn(QPainter& painter, bool is_clockwise, const QColor& colour) {
  painter.save();
  if (!is_clockwise) painter.scale(-1, 1);
  painter.setPen(QPen(colour, 0.16, Qt::SolidLine, Qt::FlatCap));
  painter.drawArc(QRectF(-0.62, -0.62, 1.24, 1.24), 0, 270 * 16);
  QPainterPath head;
  head.moveTo(0.62 - 0.3, -0.02);
  head.lineTo(0.62 + 0.3, -0.02);
  head.lineTo(0.62, 0.4);
  head.closeSubpath();
  painter.fillPath(head, colour);
  painter.restore();
}

void drawCross(QPainter& painter, const QColor& colour) {
  painter.setPen(QPen(colour, 0.2, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(-0.6, -0.6), QPointF(0.6, 0.6));
  painter.drawLine(QPointF(-0.6, 0.6), QPointF(0.6, -0.6));
}

}  // namespace

GuidanceScreen::GuidanceScreen(QWidget* parent) : QWidget(parent, Qt::Window) {
  setWindowTitle(tr("FaceNav: guidance"));
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void GuidanceScreen::set(const guidance::GuidanceState& guidance, const ReadOut& read_out) {
  read_out_ = read_out;
  const bool is_known = read_out.level == Level::good || read_out.level == Level::caution;
  const auto& values = guidance.values;
  action_ = !is_known || !values            ? guidance::Action::none
            : read_out.level == Level::good ? guidance::Action::hold
                                            : guidance.action;
  word_ = wordFor(action_, read_out);
  figure_.clear();
  distance_.clear();
  arrow_rad_.reset();
  if (is_known && values) {
    figure_ = figureFor(action_, *values);
    distance_ = tr("%1 mm away").arg(values->distance_mm, 0, 'f', 1);
    if (action_ == guidance::Action::move) arrow_rad_ = onScreen_rad(values->lateral_in_coil_mm);
    turn_rad_ = -values->twist_rad;
    // The end that must rise, as in guidance/instruction.h.
    const Eigen::Vector2d& tilt_rad = values->tilt_in_coil_rad;
    tilts_handle_ = std::abs(tilt_rad.x()) >= std::abs(tilt_rad.y());
    tilts_left_up_ = (tilts_handle_ ? tilt_rad.x() : tilt_rad.y()) > 0;
  }
  setAccessibleName(word_ + ' ' + figure_);
  update();
}

void GuidanceScreen::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), themeColour(Colour::ground));
  const bool is_wide = width() > 1.2 * height();
  const double side =
      is_wide ? std::min(0.46 * width(), 0.92 * height()) : std::min(0.92 * width(), 0.5 * height());
  const QRectF square(0.02 * width(), is_wide ? 0.5 * (height() - side) : 0.02 * height(), side, side);
  drawGlyph(painter, square);
  const QRectF room =
      is_wide ? QRectF(square.right() + 0.03 * width(), 0.03 * height(), 0.96 * width() - square.right(),
                       0.94 * height())
              : QRectF(0.03 * width(), square.bottom(), 0.94 * width(), 0.97 * height() - square.bottom());
  drawWords(painter, room);
}

/// Draws the glyph in units of half the square, the middle at (0, 0), y down.
void GuidanceScreen::drawGlyph(QPainter& painter, const QRectF& square) const {
  const QColor colour = colourOf(read_out_.level);
  painter.save();
  painter.translate(square.center());
  painter.scale(square.width() / 2, square.height() / 2);
  const bool is_good = read_out_.level == Level::good;
  if (action_ != guidance::Action::none) {
    painter.setPen(QPen(is_good ? colour : themeColour(Colour::muted), is_good ? 0.14 : 0.04));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(0, 0), 0.92, 0.92);
  }
  switch (action_) {
    case guidance::Action::move:
      drawArrow(painter, arrow_rad_.value_or(0), colour);
      break;
    case guidance::Action::lift:
    case guidance::Action::press:
      drawLift(painter, action_ == guidance::Action::lift, colour);
      break;
    case guidance::Action::tilt:
      drawTilt(painter, tilts_left_up_, tilts_handle_, colour);
      break;
    case guidance::Action::turn:
      drawTurn(painter, turn_rad_ > 0, colour);
      break;
    case guidance::Action::hold:
      painter.setPen(Qt::NoPen);
      painter.setBrush(colour);
      painter.drawEllipse(QPointF(0, 0), 0.36, 0.36);
      break;
    case guidance::Action::none:
      drawCross(painter, colour);
  }
  painter.restore();
}

/// Draws word, figure, what to do, and the distance.
void GuidanceScreen::drawWords(QPainter& painter, const QRectF& room) const {
  const double h = height(), least = kLeastLetters * h;
  double y = room.top();
  const auto line = [&](const QString& words, double size, const QColor& colour) {
    if (words.isEmpty()) return;
    painter.setFont(lettersIn(*this, words, size, room.width()));
    painter.setPen(colour);
    const double height_px = QFontMetricsF(painter.font()).height();
    painter.drawText(QRectF(room.left(), y, room.width(), height_px), Qt::AlignLeft | Qt::AlignVCenter,
                     words);
    y += height_px;
  };
  line(word_, 0.16 * h, colourOf(read_out_.level));
  line(figure_, 0.24 * h, themeColour(Colour::text));
  const double below_px = distance_.isEmpty() ? 0 : 1.5 * least;
  const QString advice = read_out_.instruction.section(": ", 1);
  painter.setFont(letters(*this, least, QFont::DemiBold));
  painter.setPen(themeColour(Colour::text));
  painter.drawText(QRectF(room.left(), y, room.width(), std::max(0.0, room.bottom() - below_px - y)),
                   Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, advice);
  y = room.bottom() - below_px;
  line(distance_, least, themeColour(Colour::muted));
}

void GuidanceScreen::closeEvent(QCloseEvent* event) {
  QWidget::closeEvent(event);
  emit closed();
}

void GuidanceScreen::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) close();
  QWidget::keyPressEvent(event);
}

}  // namespace facenav::ui
