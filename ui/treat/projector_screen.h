#pragma once
// ProjectorScreen: the window on the projector: its picture and nothing else, black where none fits the
// newest state.

#include <QImage>
#include <QWidget>
#include <memory>

#include "facenav/pictures/overlay_worker.h"

namespace facenav::ui {

class ProjectorScreen : public QWidget {
  Q_OBJECT

 public:
  explicit ProjectorScreen(QWidget* parent);
  /// From now on shows only a picture that fits `now` (not null).
  void follow(std::shared_ptr<const session::NavigationState> now);
  /// Ignored if it does not fit the newest state.
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
  QImage image_;  // null: black
};

}  // namespace facenav::ui
