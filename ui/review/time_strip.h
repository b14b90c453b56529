#pragma once
// TimeStrip: a session as a band: on target (tall, blue), adjust (half as tall, orange), lost (a thin grey
// line), with the pulses as ticks below it and the present moment as a line. A click or drag moves to that
// moment.

#include <QPixmap>
#include <QWidget>

namespace facenav::ui {

class ReplayPresenter;

class TimeStrip : public QWidget {
  Q_OBJECT

 public:
  explicit TimeStrip(ReplayPresenter& presenter, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void goTo(int x_px);
  void drawBand();

  ReplayPresenter& presenter_;
  QPixmap band_;
};

}  // namespace facenav::ui
