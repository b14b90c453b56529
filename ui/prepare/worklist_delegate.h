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
  /// Fills the editor only once, so that an update of the list does not overwrite what is being typed.
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;

 protected:
  /// Return stores the label and is not passed on: on the list itself it would open the case.
  bool eventFilter(QObject* editor, QEvent* event) override;
};

}  // namespace facenav::ui
