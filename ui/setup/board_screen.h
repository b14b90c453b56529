#pragma once
// BoardScreen: the calibration board on a whole screen (a second screen or a tablet that mirrors it). Its
// square is measured with a ruler and typed in. Escape or a click closes it.

#include <QImage>
#include <QWidget>

#include "facenav/cameras/chessboard.h"

namespace facenav::ui {

class BoardScreen : public QWidget {
  Q_OBJECT

 public:
  explicit BoardScreen(const cameras::Board& board, QWidget* parent = nullptr);
  /// On the last screen: the second one, where there is one.
  void showOnScreen();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  cameras::Board board_;
};

}  // namespace facenav::ui
