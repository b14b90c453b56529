#pragma once
// CameraRow: both cameras side by side, plain or with what tracking detects drawn over them. The drawn images
// arrive late from another thread (pictures/overlay_worker.h). One that does not match the newest state is
// not shown, and is removed if it is shown already.

#include <QWidget>
#include <memory>

#include "facenav/pictures/overlay_worker.h"
#include "facenav/stereo/picked_spot.h"

namespace facenav::ui {

class ImageView;

class CameraRow : public QWidget {
  Q_OBJECT

 public:
  explicit CameraRow(QWidget* parent = nullptr);

  /// Shows the images themselves, before tracking starts.
  void showPlain(const cameras::StereoFrame& frame);
  /// Shows drawn pictures that do not move, such as those of an alignment.
  void showStill(std::shared_ptr<const pictures::CameraOverlay> still);
  /// Shows only images that match `now` (not null) from now on.
  void follow(std::shared_ptr<const session::NavigationState> now);
  /// Shows a drawn image; ignored if it does not match the newest state.
  void showDrawn(std::shared_ptr<const pictures::DrawnOverlay> drawn);
  /// The shown overlay; null: none.
  std::shared_ptr<const pictures::DrawnOverlay> shown() const { return shown_; }

 signals:
  /// The user clicked on a live picture: position in px, and the state that the picture shows.
  void picked(facenav::stereo::PictureSide side, const QPointF& px,
              std::shared_ptr<const facenav::session::NavigationState> state);

 private:
  void clear(const QString& why = {});
  /// Reason if `drawn` is too old to be shown; else empty.
  QString lateWords(const pictures::DrawnOverlay& drawn) const;

  ImageView *left_, *right_;
  std::shared_ptr<const session::NavigationState> now_;
  std::shared_ptr<const pictures::DrawnOverlay> shown_;  // null: plain images, or none
  bool is_empty_ = true;
  QString why_empty_;
  std::shared_ptr<const pictures::CameraOverlay> still_;  // null: none is shown
};

}  // namespace facenav::ui
