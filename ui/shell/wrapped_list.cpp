#include "shell/wrapped_list.h"

#include <QStyledItemDelegate>
#include <QTextLayout>
#include <algorithm>
#include <cmath>

namespace facenav::ui {
namespace {

constexpr int kAbove_px = 2;  // above and below the text

/// Adds tick box and padding to the size; Qt's hint ignores them, so the last line would be cut.
class WholeSentence : public QStyledItemDelegate {
 public:
  explicit WholeSentence(const QAbstractItemView& view) : view_(view) {}

  QSize sizeHint(const QStyleOptionViewItem& given, const QModelIndex& index) const override {
    QStyleOptionViewItem option = given;
    initStyleOption(&option, index);
    const QStyle& style = *view_.style();
    constexpr int kTall_px = 1000;
    option.rect = QRect(0, 0, view_.viewport()->width(), kTall_px);
    const QRect room = style.subElementRect(QStyle::SE_ItemViewItemText, &option, &view_);
    const int width =
        room.width() - 2 * (style.pixelMetric(QStyle::PM_FocusFrameHMargin, &option, &view_) + 1);
    QTextOption how;
    how.setWrapMode(QTextOption::WordWrap);
    QTextLayout layout(QString(option.text).replace('\n', QChar::LineSeparator), option.font);
    layout.setTextOption(how);
    double height = 0;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(width);
      height += line.height();
    }
    layout.endLayout();
    const int padding = std::max(0, kTall_px - room.height());
    return {view_.viewport()->width(), int(std::ceil(height)) + padding + 2 * kAbove_px};
  }

 private:
  const QAbstractItemView& view_;
};

}  // namespace

WrappedList::WrappedList(QWidget* parent) : QListWidget(parent) {
  setWordWrap(true);
  setTextElideMode(Qt::ElideNone);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  auto* delegate = new WholeSentence(*this);
  delegate->setParent(this);
  setItemDelegate(delegate);
}

void WrappedList::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  scheduleDelayedItemsLayout();
}

}  // namespace facenav::ui
