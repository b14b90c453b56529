#include "setup/latency_screen.h"

#include <QKeyEvent>
#include <QPainter>

#include "facenav/core/error.h"
#include "facenav/core/timestamp.h"
#include "shell/shown_words.h"

namespace facenav::ui {

LatencyScreen::LatencyScreen(std::function<std::shared_ptr<const cameras::StereoFrame>()> latest,
                             QWidget* parent, int changes)
    : QWidget(parent, Qt::Window), latest_(std::move(latest)), meter_(changes) {
  setWindowTitle(tr("FaceNav: time from the camera to the screen"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(1);
  connect(&timer_, &QTimer::timeout, this, &LatencyScreen::look);
  timer_.start();
}

void LatencyScreen::look() {
  if (const auto frame = latest_(); frame && frame->number != last_) {
    last_ = frame->number;
    meter_.add(frame->left, frame->captured.s, Timestamp::now().s);
  }
  if (meter_.isDone()) return finish();
  if (isVisible() && Timestamp::now().s >= meter_.nextChange_s()) flash();
}

/// Flashes; repaint() returns when the picture was passed to the screen.
void LatencyScreen::flash() {
  is_lit_ = meter_.isLitNext();
  repaint();
  meter_.shown(Timestamp::now().s);
}

void LatencyScreen::finish() {
  timer_.stop();
  try {
    words_ = shownWords(meter_.result().words());
  } catch (const Error& error) {
    words_ = shownWords(error);
  }
  update();
}

void LatencyScreen::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), words_.isEmpty() && is_lit_ ? Qt::white : Qt::black);
  painter.setPen(words_.isEmpty() ? Qt::gray : Qt::white);
  const QString text = !words_.isEmpty()
                           ? words_
                           : tr("point the left camera at this window and let it fill the picture (%1 %)")
                                 .arg(100 * meter_.progress(), 0, 'f', 0);
  painter.drawText(
      rect().adjusted(24, 24, -24, -24),
      (words_.isEmpty() ? Qt::AlignBottom : Qt::AlignVCenter) | Qt::AlignHCenter | Qt::TextWordWrap, text);
}

void LatencyScreen::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) close();
  QWidget::keyPressEvent(event);
}

}  // namespace facenav::ui
