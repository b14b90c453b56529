#pragma once
// A list of choice that is wide enough for its words. QComboBox asks for the width of the ink, and cuts a few
// pixels of large letters.

#include <QComboBox>

namespace facenav::ui {

class WholeChoice : public QComboBox {
 public:
  using QComboBox::QComboBox;
  QSize sizeHint() const override { return QComboBox::sizeHint() + room(); }
  QSize minimumSizeHint() const override { return QComboBox::minimumSizeHint() + room(); }

 private:
  QSize room() const { return {fontMetrics().averageCharWidth() / 2, 0}; }
};

}  // namespace facenav::ui
