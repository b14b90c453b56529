#pragma once
// SliceView: one anatomical plane through the crosshair. Left: crosshair, wheel: slice, right: zoom, middle:
// pan, Ctrl+left: window and level, double click: choose a point, 1:1 (or R): reset zoom, pan and window, a
// click of the right button: menu. The image comes from scene::SliceScene.

#include <QImage>
#include <QPoint>
#include <QStringList>
#include <QWidget>
#include <memory>

#include "facenav/scene/slice_scene.h"
#include "shell/slice_tool.h"
#include "shell/view_menu.h"

class QToolButton;

namespace facenav::ui {

class SliceView : public QWidget {
  Q_OBJECT

 public:
  SliceView(volume::Anatomical orientation, QWidget* parent = nullptr);
  /// Sets the scene, which the linked views share; null: empty.
  void setScene(std::shared_ptr<scene::SliceScene> scene);
  /// Draws again after the scene's content changed.
  void refresh();
  /// Resets zoom and pan.
  void reset();
  /// "axial  88/176", "S 12.3 mm" and "value 512": number and position of the slice, and the MRI's value at
  /// the crosshair. Empty without a scene.
  QStringList caption() const;
  /// Sets a tool, which must outlive the view; null: none. While it is active, the left button draws.
  void setTool(SliceTool* tool);
  /// What its menu offers at a place in the view.
  ViewOffers offersAt(const QPoint& position);

 signals:
  void crosshairMoved(double x_mm, double y_mm, double z_mm);
  void chosen(double x_mm, double y_mm, double z_mm);
  /// The scene's window changed; the linked views draw again.
  void windowChanged();
  /// The user asks to reset zoom, pan and window in all linked views.
  void resetWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  bool draws() const { return tool_ && tool_->isActive(); }
  void paintTool(QPainter& painter);
  void paintCaption(QPainter& painter);
  volume::SlicePlane plane() const;
  Point<Mri> pointAt(const QPoint& position) const;
  void moveCrosshair(const Point<Mri>& to);
  void goBy(double step_mm);

  volume::Anatomical orientation_;
  std::shared_ptr<scene::SliceScene> scene_;
  QImage picture_;
  bool is_outdated_ = true;
  double zoom_ = 1.0;
  Eigen::Vector2d pan_mm_ = Eigen::Vector2d::Zero();
  QPoint last_, pressed_at_, pointer_{-1, -1};
  SliceTool* tool_ = nullptr;
  QToolButton* reset_;
  bool is_stroke_ = false;
};

}  // namespace facenav::ui
