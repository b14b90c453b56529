#include "setup/projector_code_screen.h"

#include <QKeyEvent>
#include <QPainter>

#include "facenav/core/timestamp.h"
#include "shell/image_view.h"
#include "shell/shown_words.h"

namespace facenav::ui {

ProjectorCodeScreen::ProjectorCodeScreen(const cameras::StereoRig& rig, const QSize& size, Latest latest,
                                         QWidget* parent)
    : QWidget(parent, Qt::Window),
      latest_(std::move(latest)),
      run_(rig, {size.width(), size.height(), stereo::ProjectorCode().period_px}) {
  setWindowTitle(tr("FaceNav: calibration of the projector"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setCursor(Qt::BlankCursor);
  timer_.setInterval(5);
  connect(&timer_, &QTimer::timeout, this, &ProjectorCodeScreen::look);
}

void ProjectorCodeScreen::startScene() {
  run_.startScene();
  timer_.start();
  repaint();
  run_.shown(Timestamp::now().s);
}

void ProjectorCodeScreen::look() {
  const auto frame = latest_();
  const double before = run_.progress();
  if (frame && frame->number != last_) {
    last_ = frame->number;
    run_.add(*frame);
  }
  run_.wait(Timestamp::now().s);
  if (run_.progress() == before) return;
  repaint();  // returns when the picture was passed to the screen
  if (run_.isShowing()) return run_.shown(Timestamp::now().s);
  timer_.stop();
  emit sceneTaken();
}

void ProjectorCodeScreen::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (run_.isShowing()) {
    const cv::Mat& picture = run_.picture();
    painter.drawImage(rect(), toQImage(picture.data, picture.cols, picture.rows, int(picture.step)));
    return;
  }
  painter.setPen(Qt::white);
  QFont font = painter.font();
  font.setPixelSize(std::max(14, height() / 22));
  painter.setFont(font);
  painter.drawText(
      rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap,
      shownWords(run_.words()) + "\n\n" + tr("Space: take a scene. Escape: keep what there is."));
}

void ProjectorCodeScreen::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !run_.isShowing()) startScene();
  if (event->key() == Qt::Key_Escape) close();
  QWidget::keyPressEvent(event);
}

}  // namespace facenav::ui
