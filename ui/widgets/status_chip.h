#pragma once
// StatusChip: a state in words, shape and colour, in this order: disc = good, triangle = caution, cross =
// lost.

#include <QWidget>

#include "presenters/read_out.h"

namespace facenav::ui {

QColor colourOf(Level level);

class StatusChip : public QWidget {
  Q_OBJECT

 public:
  explicit StatusChip(QWidget* parent = nullptr);
  void set(const Chip& chip);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Chip chip_;
};

}  // namespace facenav::ui
