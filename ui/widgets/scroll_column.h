#pragma once
// ScrollColumn: a column that scrolls up and down where there is no room for all of it; never sideways.

#include <QScrollArea>

namespace facenav::ui {

class ScrollColumn : public QScrollArea {
 public:
  /// Takes the content over. As wide as the content needs, and no less than `width_px`.
  ScrollColumn(QWidget* content, int width_px, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  int least_width_px_;
};

}  // namespace facenav::ui
