#pragma once
// ProjectorScreen: the window on the projector: only its picture, black if none matches the newest state.

#include <QImage>
#include <QWidget>
#include <memory>

#include "facenav/pictures/overlay_worker.h"

namespace facenav::ui {

class ProjectorScreen : public QWidget {
  Q_OBJECT

 public:
  explicit ProjectorScreen(QWidget* parent);
  /// Shows only a picture that matches `now` (not null) from now on.
  void follow(std::shared_ptr<const session::NavigationState> now);
  /// Shows a picture; ignored if it does not match the newest state.
  void showDrawn(std::shared_ptr<const pictures::DrawnOverlay> picture);
  bool isBlack() const { return image_.isNull(); }

 signals:
  void closed();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::shared_ptr<const session::NavigationState> now_;
  std::shared_ptr<const pictures::DrawnOverlay> shown_;
  QImage image_;  // null if black
};

}  // namespace facenav::ui
