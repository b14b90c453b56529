#pragma once
// WrappedList: a list whose items are whole sentences, each on as many lines as it needs.

#include <QListWidget>

namespace facenav::ui {

class WrappedList : public QListWidget {
  Q_OBJECT

 public:
  explicit WrappedList(QWidget* parent = nullptr);

 protected:
  /// A narrower list needs taller items.
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace facenav::ui
