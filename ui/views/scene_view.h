#pragma once
// SceneView: a NavigationScene in a widget. Left: rotate, middle: pan, right: zoom; a click without a drag
// picks.

#include <QVTKOpenGLNativeWidget.h>

#include <QPoint>
#include <memory>

#include "facenav/scene/navigation_scene.h"
#include "presenters/case_model.h"

namespace facenav::ui {

class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  scene::NavigationScene& scene() { return *scene_; }
  /// Patient, targets and slices of a case.
  void show(const LoadedCase& loaded);
  void refresh();

 signals:
  void picked(double x_mm, double y_mm, double z_mm, bool is_brain);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::unique_ptr<scene::NavigationScene> scene_;
  QPoint pressed_at_;
};

}  // namespace facenav::ui
