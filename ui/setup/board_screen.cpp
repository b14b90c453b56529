#include "setup/board_screen.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPainter>
#include <QScreen>

#include "facenav/cameras/board_page.h"
#include "shell/image_view.h"

namespace facenav::ui {

BoardScreen::BoardScreen(const cameras::Board& board, QWidget* parent)
    : QWidget(parent, Qt::Window), board_(board) {
  setWindowTitle(tr("FaceNav: calibration board"));
  setAttribute(Qt::WA_DeleteOnClose);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setCursor(Qt::BlankCursor);
}

void BoardScreen::showOnScreen() {
  setGeometry(QApplication::screens().last()->geometry());
  showFullScreen();
}

void BoardScreen::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QSize pixels = size() * devicePixelRatioF();
  painter.fillRect(rect(), Qt::white);
  if (pixels.width() < 100 || pixels.height() < 100) return;
  const cv::Mat picture = cameras::boardPicture(board_, {pixels.width(), pixels.height()});
  painter.drawImage(rect(), toQImage(picture.data, picture.cols, picture.rows, int(picture.step)));
  painter.setPen(Qt::gray);
  painter.drawText(rect().adjusted(8, 4, -8, -4), Qt::AlignLeft | Qt::AlignBottom,
                   tr("measure one square with a ruler and type it in; Escape closes this"));
}

void BoardScreen::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) close();
  QWidget::keyPressEvent(event);
}

void BoardScreen::mousePressEvent(QMouseEvent*) { close(); }

}  // namespace facenav::ui
