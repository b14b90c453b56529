#pragma once
// ElidedLabel: one line that ends in an ellipsis where there is no room for all of it; the whole is in its
// tooltip.

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
