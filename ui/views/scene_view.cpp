#include "views/scene_view.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include <QMouseEvent>

namespace facenav::ui {

SceneView::SceneView(QWidget* parent)
    : QVTKOpenGLNativeWidget(parent), scene_(std::make_unique<scene::NavigationScene>()) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  setRenderWindow(window);
  scene_->attach(window);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor()->SetInteractorStyle(style);
  setMinimumSize(200, 160);
  setToolTip(tr("left: rotate   middle: pan   right: zoom   click: choose a point"));
}

SceneView::~SceneView() = default;

void SceneView::show(const LoadedCase& loaded) {
  scene_->setScalp(loaded.scalp->mesh);
  if (loaded.brain)
    scene_->setBrain(*loaded.brain);
  else
    scene_->clearBrain();
  scene_->setVolume(*loaded.mri);
  refresh();
}

void SceneView::refresh() {
  if (isVisible()) renderWindow()->Render();
}

void SceneView::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = event->pos();
  QVTKOpenGLNativeWidget::mousePressEvent(event);
}

void SceneView::mouseReleaseEvent(QMouseEvent* event) {
  QVTKOpenGLNativeWidget::mouseReleaseEvent(event);
  if (event->button() != Qt::LeftButton || (event->pos() - pressed_at_).manhattanLength() > 3) return;
  const double ratio = devicePixelRatioF();
  const auto pick =
      scene_->pick(int(event->pos().x() * ratio), int((height() - 1 - event->pos().y()) * ratio));
  if (pick) emit picked(pick->point.mm.x(), pick->point.mm.y(), pick->point.mm.z(), pick->is_brain);
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  scene_->attach(renderWindow());  // the head icon keeps its shape
}

}  // namespace facenav::ui
