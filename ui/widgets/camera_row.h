#pragma once
// CameraRow: both cameras side by side, as they are or with what tracking sees drawn over them. The pictures
// come drawn from elsewhere (pictures/overlay_worker.h) and late: one that no longer fits the newest state is
// not shown, and is taken away where it stands.

#include <QWidget>
#include <memory>

#include "facenav/pictures/overlay_worker.h"

namespace facenav::ui {

class ImageView;

class CameraRow : public QWidget {
  Q_OBJECT

 public:
  explicit CameraRow(QWidget* parent = nullptr);

  /// The pictures themselves, before anything is tracked.
  void showPlain(const cameras::StereoFrame& frame);
  /// From now on only what may stand beside `now` (not null) is shown.
  void follow(std::shared_ptr<const session::NavigationState> now);
  /// A finished picture; left out where it does not fit the newest state.
  void showDrawn(std::shared_ptr<const pictures::DrawnOverlay> drawn);
  /// Of the state that is shown; null: none is.
  std::shared_ptr<const pictures::DrawnOverlay> shown() const { return shown_; }

 private:
  void clear();

  ImageView *left_, *right_;
  std::shared_ptr<const session::NavigationState> now_;
  std::shared_ptr<const pictures::DrawnOverlay> shown_;  // null: plain pictures, or none
  bool is_empty_ = true;
};

}  // namespace facenav::ui
