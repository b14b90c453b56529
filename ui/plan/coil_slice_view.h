#pragma once
// CoilSliceView: the MRI on a plane along the coil's axis (scene/coil_slices.h), for a planned coil or the
// live one. Without a coil it shows words and no picture. Left: crosshair, double click: choose a point,
// right: zoom, Ctrl+left: window and level.

#include <QImage>
#include <QPoint>
#include <QWidget>
#include <memory>

#include "facenav/scene/coil_slices.h"
#include "shell/view_menu.h"

namespace facenav::ui {

class CoilSliceView : public QWidget {
  Q_OBJECT

 public:
  CoilSliceView(scene::CoilCut cut, QWidget* parent = nullptr);
  /// Sets the scene, which the linked views share; null: empty.
  void setScene(std::shared_ptr<scene::SliceScene> scene);
  /// Sets the coil. Without one the last slice is removed at once and `words` give the reason.
  void setCoil(const std::optional<scene::SlicedCoil>& coil, const QString& words = {});
  /// Draws again after the scene's content changed.
  void refresh();
  /// Resets the zoom.
  void reset();
  /// True while a slice is drawn.
  bool showsSlice() const { return coil_ && scene_ && scene_->mri; }
  /// "along: cortex 21 mm below the scalp", "across: beam 0.4 mm off"; "along the handle" without a target.
  QString caption() const;
  /// "ring: 95 % within 1.6 mm"; empty where it is not known.
  QString boundWords() const;
  /// Text in place of the slice.
  QString words() const { return words_; }
  /// What its menu offers at a place in the view.
  ViewOffers offersAt(const QPoint& position);

 signals:
  void crosshairMoved(double x_mm, double y_mm, double z_mm);
  void chosen(double x_mm, double y_mm, double z_mm);
  /// The scene's window changed; the linked views draw again.
  void windowChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  volume::SlicePlane plane() const;

  scene::CoilCut cut_;
  std::shared_ptr<scene::SliceScene> scene_;
  std::optional<scene::SlicedCoil> coil_;
  QString words_;
  QImage picture_;
  bool is_outdated_ = true;
  double zoom_ = 1.0;
  QPoint last_, pressed_at_;
};

}  // namespace facenav::ui
