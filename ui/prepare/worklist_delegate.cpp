#include "prepare/worklist_delegate.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>

#include "prepare/worklist_table.h"
#include "shell/status_chip.h"
#include "shell/theme.h"

namespace facenav::ui {
namespace {

const char* const kIsFilled = "is_filled";  // property of an editor whose text is set

QColor colourOf(Mark mark) {
  if (mark == Mark::done) return colourOf(Level::good);
  return colourOf(mark == Mark::waiting ? Level::lost : Level::caution);
}

void drawMark(QPainter& painter, Mark mark, const QPointF& c) {
  const double r = 5.5;
  const QColor colour = colourOf(mark);
  painter.setPen(QPen(colour, 2.2));
  painter.setBrush(mark == Mark::done || mark == Mark::look ? QBrush(colour) : QBrush(Qt::NoBrush));
  if (mark == Mark::done || mark == Mark::waiting) painter.drawEllipse(c, r, r);
  if (mark == Mark::look)
    painter.drawPolygon(QPolygonF({c + QPointF(0, -r), c + QPointF(r, r), c + QPointF(-r, r)}));
  if (mark == Mark::fault) {
    painter.drawLine(c + QPointF(-r, -r), c + QPointF(r, r));
    painter.drawLine(c + QPointF(-r, r), c + QPointF(r, -r));
  }
}

}  // namespace

void WorklistDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given,
                             const QModelIndex& index) const {
  QStyleOptionViewItem option = given;
  const double fraction = index.data(WorklistTable::kFractionRole).toDouble();
  if (index.column() == WorklistTable::detail && fraction >= 0.0) {
    const QRect bar(option.rect.left(), option.rect.bottom() - 4, option.rect.width() - 8, 3);
    painter->fillRect(bar, themeColour(Colour::bar_rest));
    painter->fillRect(QRect(bar.topLeft(), QSize(int(bar.width() * std::clamp(fraction, 0.0, 1.0)), 3)),
                      colourOf(Level::good));
  }
  if (index.column() == WorklistTable::state) option.rect.adjust(26, 0, 0, 0);
  QStyledItemDelegate::paint(painter, option, index);
  if (index.column() != WorklistTable::state) return;
  if (option.state & QStyle::State_Selected)
    painter->fillRect(QRect(given.rect.topLeft(), QSize(26, given.rect.height())),
                      option.palette.highlight());
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  drawMark(*painter, Mark(index.data(WorklistTable::kMarkRole).toInt()),
           QPointF(given.rect.left() + 14, given.rect.center().y() + 0.5));
  painter->restore();
}

void WorklistDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  if (editor->property(kIsFilled).toBool()) return;
  editor->setProperty(kIsFilled, true);
  QStyledItemDelegate::setEditorData(editor, index);
}

bool WorklistDelegate::eventFilter(QObject* watched, QEvent* event) {
  auto* editor = qobject_cast<QWidget*>(watched);
  if (!editor || event->type() != QEvent::KeyPress) return QStyledItemDelegate::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return QStyledItemDelegate::eventFilter(watched, event);
  emit commitData(editor);
  emit closeEditor(editor, SubmitModelCache);
  return true;
}

}  // namespace facenav::ui
