#pragma once
// ElidedLabel: one line of text that ends in an ellipsis if it does not fit; the tooltip has the whole text.

#include <QLabel>

namespace facenav::ui {

class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);
  void set(const QString& words);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace facenav::ui
