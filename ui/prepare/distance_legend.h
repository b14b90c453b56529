#pragma once
// DistanceLegend: the scale of the distance colour map, in mm.

#include <QWidget>

namespace facenav::ui {

class DistanceLegend : public QWidget {
  Q_OBJECT

 public:
  explicit DistanceLegend(QWidget* parent = nullptr);
  /// Colours run from -full_mm to +full_mm.
  void setScale(double full_mm);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double full_mm_ = 2.0;
};

}  // namespace facenav::ui
