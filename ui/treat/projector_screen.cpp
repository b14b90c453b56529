#include "treat/projector_screen.h"

#include <QKeyEvent>
#include <QPainter>

#include "shell/image_view.h"

namespace facenav::ui {

ProjectorScreen::ProjectorScreen(QWidget* parent) : QWidget(parent, Qt::Window) {
  setWindowTitle(tr("FaceNav: projector"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setCursor(Qt::BlankCursor);
}

void ProjectorScreen::follow(std::shared_ptr<const session::NavigationState> now) {
  now_ = std::move(now);
  if (!shown_ || pictures::mayBeShown(*shown_, *now_)) return;
  shown_.reset();
  image_ = {};
  update();
}

void ProjectorScreen::showDrawn(std::shared_ptr<const pictures::DrawnOverlay> picture) {
  if (!now_ || !pictures::mayBeShown(*picture, *now_)) return;
  shown_ = std::move(picture);
  image_ = shown_->failure.empty() ? toQImage(shown_->overlay.left) : QImage();
  update();
}

/// Fills the window with the whole picture, for which the calibration is valid; pixel by pixel if the sizes
/// match.
void ProjectorScreen::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (image_.isNull()) return;
  painter.setRenderHint(QPainter::SmoothPixmapTransform, image_.size() != size() * devicePixelRatioF());
  painter.drawImage(rect(), image_);
}

void ProjectorScreen::closeEvent(QCloseEvent* event) {
  QWidget::closeEvent(event);
  emit closed();
}

void ProjectorScreen::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) close();
  QWidget::keyPressEvent(event);
}

}  // namespace facenav::ui
