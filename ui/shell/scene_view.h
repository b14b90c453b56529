#pragma once
// SceneView: a NavigationScene in a widget. Left: rotate, middle: pan, right: zoom; a click without a drag
// picks.

#include <QVTKOpenGLNativeWidget.h>

#include <QPoint>
#include <QPolygon>
#include <QTimer>
#include <memory>

#include "facenav/scene/navigation_scene.h"
#include "shell/case_model.h"
#include "shell/view_menu.h"

namespace facenav::ui {

class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  scene::NavigationScene& scene() { return *scene_; }
  /// Shows patient, targets and slices of a case.
  void show(const LoadedCase& loaded);
  void refresh();
  /// Draws again during a motion: a simplified scene if full rendering is slow here, and the full one when
  /// the motion ends.
  void refreshMoving() { refreshQuickly(true); }
  /// Draws again without the skin while a slider moves.
  void refreshPeeling() { refreshQuickly(false); }
  /// Shares one camera between both views; each follows when the other is turned.
  void shareCamera(SceneView& other);
  /// True: the left button draws a closed line instead of turning the view (scalpel).
  void setDrawing(bool is_drawing);
  /// The current projection.
  scene::SceneProjection projection() const { return scene_->projection(width(), height()); }
  /// What its menu offers at a place in the view: the surface there, if there is one.
  ViewOffers offersAt(const QPoint& position);

 signals:
  /// turned: the user moved the camera. drawn: the view was rendered.
  void turned();
  void drawn();
  /// The user drew a closed line of at least three corners; x right, y up, each -1..1, as in projection().
  void outlineDrawn(const std::vector<Eigen::Vector2d>& outline);
  void picked(double x_mm, double y_mm, double z_mm, bool is_brain);
  /// The user asks, in the menu, to move the crosshair here.
  void placeWanted(double x_mm, double y_mm, double z_mm);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool event(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintGL() override;

 private:
  std::unique_ptr<scene::NavigationScene> scene_;
  bool drawsQuickly(bool is_skin_shown);
  void refreshQuickly(bool is_skin_shown);
  void showLine();
  std::optional<scene::ScenePick> pickAt(const QPoint& position) const;

  QWidget* line_;  // drawn over the image
  QPolygon outline_;
  bool draws_ = false, has_seen_focus_ = false;
  QPoint pressed_at_;
  QTimer rest_;
  double whole_ms_ = 0.0;
  bool is_quick_ = false, is_skin_shown_ = true;
  QSize attached_px_;  // size of the window that the scene was placed for
};

}  // namespace facenav::ui
