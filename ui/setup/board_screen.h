#pragma once
// BoardScreen: shows the calibration board on a whole screen (a second screen or a tablet that mirrors it).
// The user measures its square with a ruler and types the size. Escape or a click closes it.

#include <QImage>
#include <QWidget>

#include "facenav/cameras/chessboard.h"

namespace facenav::ui {

class BoardScreen : public QWidget {
  Q_OBJECT

 public:
  explicit BoardScreen(const cameras::Board& board, QWidget* parent = nullptr);
  /// Opens on the last screen, which is the second one if there are two.
  void showOnScreen();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  cameras::Board board_;
};

}  // namespace facenav::ui
