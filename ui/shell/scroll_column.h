#pragma once
// ScrollColumn: a column that scrolls vertically if its content does not fit; never sideways.

#include <QScrollArea>

namespace facenav::ui {

class ScrollColumn : public QScrollArea {
 public:
  /// Takes ownership of the content. As wide as the content needs, at least `width_px`.
  ScrollColumn(QWidget* content, int width_px, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

  /// Scrolls the column around `widget`, if there is one, until the widget is in view.
  static void bringIntoView(QWidget& widget);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  int least_width_px_;
};

}  // namespace facenav::ui
