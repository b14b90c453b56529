#pragma once
// OverlayWorker: draws the camera overlays (camera_overlay.h) on its own thread, so that the window never
// waits for them. Only the newest order is drawn; an order that still waits is replaced. Each picture holds
// the state it was drawn from; mayBeShown() tells whether it is still valid beside the newest state.

#include <functional>
#include <memory>
#include <string>

#include "facenav/pictures/camera_overlay.h"

namespace facenav::pictures {

struct OverlayOrder {
  cameras::StereoRig rig;
  std::shared_ptr<const session::NavigationState> state;  // not null
  std::optional<guidance::Target> target;
  std::optional<AlignmentShown> alignment = {};
};

struct DrawnOverlay {
  CameraOverlay overlay;
  std::shared_ptr<const session::NavigationState> state;  // the state it was drawn from
  Timestamp captured;                                     // capture time of its images, the source's clock
  std::string failure;                                    // why nothing could be drawn; empty: no failure
};

/// A picture may be shown while `now` is the newest state if head, coil and target have the same status in
/// both, and its frame arrived at or before that of `now`, at most the age limit of a pose earlier.
bool mayBeShown(const DrawnOverlay& drawn, const session::NavigationState& now);
/// Its frame arrived longer before that of `now` than the age limit of a pose.
bool isTooOld(const DrawnOverlay& drawn, const session::NavigationState& now);

class OverlayWorker {
 public:
  using Draw = std::function<CameraOverlay(const OverlayOrder&)>;
  /// Called on the worker's thread for each finished picture. A failure is logged and also delivered.
  using Deliver = std::function<void(std::shared_ptr<const DrawnOverlay>)>;

  explicit OverlayWorker(Deliver deliver, Draw draw = {});  // no `draw`: uses drawOverlay
  /// Waits for the picture that is being drawn; it is not delivered.
  ~OverlayWorker();
  OverlayWorker(const OverlayWorker&) = delete;
  OverlayWorker& operator=(const OverlayWorker&) = delete;

  /// Returns at once.
  void ask(OverlayOrder order);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::pictures
