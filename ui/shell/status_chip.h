#pragma once
// StatusChip: a state in words, shape and colour: disc = good, triangle = caution, cross = lost.

#include <QWidget>

#include "treat/read_out.h"

namespace facenav::ui {

QColor colourOf(Level level);

class StatusChip : public QWidget {
  Q_OBJECT

 public:
  /// `longest`: the longest text it may show. Its width is reserved, so that no text is cut.
  explicit StatusChip(const QString& longest, QWidget* parent = nullptr);
  void set(const Chip& chip);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Chip chip_;
  QString longest_;
};

}  // namespace facenav::ui
