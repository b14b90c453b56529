#include "review/chart_painter.h"
#include "shell/shown_words.h"

#include <QPainter>

#include "shell/theme.h"

namespace facenav::ui {
namespace {

using report::ChartShape;
using report::Ink;

QColor colourOf(Ink ink, ChartPaper paper) {
  const bool is_paper = paper == ChartPaper::white;
  switch (ink) {
    case Ink::words:
    case Ink::limit:
      return themeColour(is_paper ? Colour::paper_text : Colour::text);
    case Ink::axis:
      return themeColour(is_paper ? Colour::paper_line : Colour::muted);
    case Ink::grid:
      return themeColour(is_paper ? Colour::paper_grid : Colour::grid);
    case Ink::on_target:
    case Ink::bar:
      return themeColour(is_paper ? Colour::paper_good : Colour::good);
    case Ink::outside:
      return themeColour(is_paper ? Colour::paper_caution : Colour::caution);
    case Ink::excluded:
      break;
  }
  return themeColour(is_paper ? Colour::paper_excluded : Colour::lost);
}

/// A chart of a report, on white paper, has the report's words; the window shows its own language.
void paintWords(QPainter& painter, const ChartShape& s, ChartPaper paper) {
  QFont font = painter.font();
  font.setPixelSize(s.is_bold ? 13 : 11);
  font.setBold(s.is_bold);
  painter.setFont(font);
  const QString words = paper == ChartPaper::window ? shownWords(s.text) : QString::fromStdString(s.text);
  const double width = QFontMetricsF(font, painter.device()).horizontalAdvance(words);
  const double back = s.anchor == ChartShape::Anchor::left     ? 0
                      : s.anchor == ChartShape::Anchor::middle ? width / 2
                                                               : width;
  painter.drawText(QPointF(s.x - back, s.y), words);
}

void paintShape(QPainter& painter, const ChartShape& s, QColor colour, ChartPaper paper) {
  using Kind = ChartShape::Kind;
  switch (s.kind) {
    case Kind::line:
      return painter.drawLine(QPointF(s.x, s.y), QPointF(s.x2, s.y2));
    case Kind::box:
      return painter.fillRect(QRectF(s.x, s.y, s.x2, s.y2), colour);
    case Kind::frame:
      return painter.drawRect(QRectF(s.x, s.y, s.x2, s.y2));
    case Kind::disc:
      colour.setAlphaF(0.6);
      painter.setPen(Qt::NoPen);
      painter.setBrush(colour);
      return painter.drawEllipse(QPointF(s.x, s.y), s.x2, s.x2);
    case Kind::circle:
      return painter.drawEllipse(QPointF(s.x, s.y), s.x2, s.x2);
    case Kind::square:
      return painter.drawRect(QRectF(s.x - s.x2, s.y - s.x2, 2 * s.x2, 2 * s.x2));
    case Kind::cross:
      painter.drawLine(QPointF(s.x - s.x2, s.y - s.x2), QPointF(s.x + s.x2, s.y + s.x2));
      return painter.drawLine(QPointF(s.x - s.x2, s.y + s.x2), QPointF(s.x + s.x2, s.y - s.x2));
    case Kind::words:
      return paintWords(painter, s, paper);
  }
}

}  // namespace

void paintChart(QPainter& painter, const report::Chart& chart, ChartPaper paper) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const ChartShape& shape : chart.shapes) {
    const QColor colour = colourOf(shape.ink, paper);
    painter.setPen(QPen(colour, 1, shape.ink == Ink::limit ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(Qt::NoBrush);
    paintShape(painter, shape, colour, paper);
  }
  painter.restore();
}

}  // namespace facenav::ui
