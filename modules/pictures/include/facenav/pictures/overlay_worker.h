#pragma once
// OverlayWorker: draws the camera overlays (camera_overlay.h) on a thread of its own, so that the window
// never waits for them. Only the newest order is drawn: one that still waits is replaced. Each picture
// carries the state that it shows; mayBeShown() says whether it still may stand beside the newest one.

#include <functional>
#include <memory>
#include <string>

#include "facenav/pictures/camera_overlay.h"

namespace facenav::pictures {

struct OverlayOrder {
  cameras::StereoRig rig;
  std::shared_ptr<const session::NavigationState> state;  // not null
  std::optional<guidance::Target> target;
};

struct DrawnOverlay {
  CameraOverlay overlay;
  std::shared_ptr<const session::NavigationState> state;  // shown by it
  Timestamp captured;                                     // of its images, the source's clock
  std::string failure;                                    // why nothing could be drawn; empty: all is well
};

/// A picture may be shown while `now` is the newest state if it says the same of head, coil and target, and
/// its frame came in before that of `now`, by no more than the age limit of any pose, or is the same.
bool mayBeShown(const DrawnOverlay& drawn, const session::NavigationState& now);

class OverlayWorker {
 public:
  using Draw = std::function<CameraOverlay(const OverlayOrder&)>;
  /// Called on the worker's thread for each finished picture. A failure is logged, and is a picture too.
  using Deliver = std::function<void(std::shared_ptr<const DrawnOverlay>)>;

  explicit OverlayWorker(Deliver deliver, Draw draw = {});  // no `draw`: drawOverlay
  /// Waits for the picture that is being drawn; none is delivered afterwards.
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
