#pragma once
// WorklistDelegate: draws the state in shape, word and colour, and the running step's progress as a bar.

#include <QStyledItemDelegate>

namespace facenav::ui {

class WorklistDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace facenav::ui
