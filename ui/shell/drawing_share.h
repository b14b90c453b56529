#pragma once
// DrawingShare: gives a drawing at most half of the time, however slow it is here, so that the rest of the
// page and the trackers get the other half.

#include <QElapsedTimer>

namespace facenav::ui {

class DrawingShare {
 public:
  /// True if at least as much time as the last drawing took has passed since its end.
  bool isDue() const { return !ended_.isValid() || ended_.nsecsElapsed() >= took_ns_; }
  /// Draws, and measures how long it takes.
  template <class Draw>
  void draw(Draw&& draw) {
    QElapsedTimer timer;
    timer.start();
    draw();
    took_ns_ = timer.nsecsElapsed();
    ended_.start();
  }

 private:
  QElapsedTimer ended_;
  qint64 took_ns_ = 0;
};

}  // namespace facenav::ui
