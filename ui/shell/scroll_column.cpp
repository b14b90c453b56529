#include "shell/scroll_column.h"

#include <QEvent>
#include <QScrollBar>
#include <algorithm>

#include "shell/appearance.h"

namespace facenav::ui {

ScrollColumn::ScrollColumn(QWidget* content, int width_px, QWidget* parent)
    : QScrollArea(parent), least_width_px_(width_px) {
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Expanding);
  setFocusPolicy(Qt::NoFocus);
  setWidgetResizable(true);
  setWidget(content);
  whenTextScales(this, [this] { updateGeometry(); });
  for (QWidget* each : {content, viewport()})
    each->setAutoFillBackground(false);  // the panel's background shows through
}

QSize ScrollColumn::sizeHint() const {
  return {minimumSizeHint().width(), widget() ? widget()->sizeHint().height() : 0};
}

QSize ScrollColumn::minimumSizeHint() const {
  const int content_px = widget() ? widget()->minimumSizeHint().width() : 0;
  return {std::max(sized(least_width_px_), content_px + verticalScrollBar()->sizeHint().width()), sized(100)};
}

void ScrollColumn::bringIntoView(QWidget& widget) {
  for (auto* parent = widget.parentWidget(); parent; parent = parent->parentWidget())
    if (auto* column = qobject_cast<QScrollArea*>(parent))
      return column->ensureWidgetVisible(&widget, 0, sized(8));
}

bool ScrollColumn::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace facenav::ui
