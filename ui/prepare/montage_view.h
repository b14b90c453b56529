#pragma once
// MontageView: all slices with the masks' contours on one sheet, as wide as the view. A double click on a
// slice asks to enlarge it.

#include <QImage>
#include <QScrollArea>
#include <QTimer>

#include "facenav/scene/contour_montage.h"
#include "shell/case_model.h"

class QLabel;

namespace facenav::ui {

class MontageView : public QScrollArea {
  Q_OBJECT

 public:
  explicit MontageView(QWidget* parent = nullptr);
  void show(const LoadedCase& loaded);
  int tiles() const { return int(montage_.tiles.size()); }

 signals:
  void chosen(double x_mm, double y_mm, double z_mm);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void draw();

  QLabel* sheet_;
  scene::SliceScene scene_;
  std::shared_ptr<const volume::Mask> content_;
  scene::Montage montage_;
  QTimer soon_;
};

}  // namespace facenav::ui
