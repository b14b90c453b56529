#pragma once
// WorklistDelegate: draws the state in shape, word and colour, and the running step's progress as a bar;
// edits labels.

#include <QStyledItemDelegate>

namespace facenav::ui {

class WorklistDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// Once: what the list says later does not overwrite what is being typed.
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;

 protected:
  /// Return stores the label and goes no further: on the list itself it opens the case.
  bool eventFilter(QObject* editor, QEvent* event) override;
};

}  // namespace facenav::ui
