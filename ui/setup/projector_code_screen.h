#pragma once
// ProjectorCodeScreen: the window on the projector while it is calibrated. It shows the code, picture by
// picture, then the result in words. Space begins a scene, Escape ends.

#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "facenav/setup/projector_run.h"

namespace facenav::ui {

class ProjectorCodeScreen : public QWidget {
  Q_OBJECT

 public:
  using Latest = std::function<std::shared_ptr<const cameras::StereoFrame>()>;
  /// `latest`: the newest pair of the running cameras, or null. `size`: size of the projector's picture.
  ProjectorCodeScreen(const cameras::StereoRig& rig, const QSize& size, Latest latest,
                      QWidget* parent = nullptr);
  void startScene();
  const steps::ProjectorRun& run() const { return run_; }

 signals:
  /// A scene was recorded; gives its result.
  void sceneTaken();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void look();

  Latest latest_;
  steps::ProjectorRun run_;
  QTimer timer_;
  std::int64_t last_ = -1;
};

}  // namespace facenav::ui
