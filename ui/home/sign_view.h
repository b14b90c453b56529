#pragma once
// SignView: the big sign of the home window: an arrow to slide along, up or down, a turn, a side to raise, or
// a tick. The coil is seen from behind its handle, which points down. Shape comes first, colour second.

#include <QWidget>

#include "facenav/home/home_advice.h"

class QPainter;

namespace facenav::ui {

class SignView : public QWidget {
  Q_OBJECT

 public:
  explicit SignView(QWidget* parent = nullptr);
  void set(steps::HomeSign sign, double arrow_rad, bool is_refused);
  steps::HomeSign sign() const { return sign_; }
  bool isRefused() const { return is_refused_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawCoil(QPainter& painter) const;

  steps::HomeSign sign_ = steps::HomeSign::none;
  double arrow_rad_ = 0;
  bool is_refused_ = false;
};

}  // namespace facenav::ui
