#pragma once
// LatencyScreen: a field that flashes white and black on the screen while a camera films it, and at the end
// the camera-to-screen latency in words (capture/latency_meter.h). Escape closes it.

#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/capture/latency_meter.h"

namespace facenav::ui {

class LatencyScreen : public QWidget {
  Q_OBJECT

 public:
  /// `latest`: the newest pair of running cameras, or null. Its left picture is used.
  explicit LatencyScreen(std::function<std::shared_ptr<const cameras::StereoFrame>()> latest,
                         QWidget* parent = nullptr, int changes = 60);
  /// The result in words; empty while it measures.
  QString words() const { return words_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void look();
  void flash();
  void finish();

  std::function<std::shared_ptr<const cameras::StereoFrame>()> latest_;
  capture::LatencyMeter meter_;
  QTimer timer_;
  std::int64_t last_ = -1;
  bool is_lit_ = false;
  QString words_;
};

}  // namespace facenav::ui
