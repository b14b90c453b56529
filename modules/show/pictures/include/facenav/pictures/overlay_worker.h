#pragma once
// OverlayWorker: draws the camera overlays (camera_overlay.h) on its own thread, so that the window never
// waits for them. A new order replaces one that still waits. Each picture carries the state it was drawn
// from; mayBeShown() compares that with the newest state.

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
  std::string failure;                                    // why drawing failed; empty: no failure
};

/// True if a picture may be shown while `now` is the newest state: head, coil and target have the same status
/// in both, and its frame arrived at or before that of `now`, at most the age limit of a pose earlier.
bool mayBeShown(const DrawnOverlay& drawn, const session::NavigationState& now);
/// True if its frame arrived before that of `now` by more than the age limit of a pose.
bool isTooOld(const DrawnOverlay& drawn, const session::NavigationState& now);

class OverlayWorker {
 public:
  using Draw = std::function<CameraOverlay(const OverlayOrder&)>;
  /// Callback on the worker's thread for each finished picture. A failure is logged and also delivered.
  using Deliver = std::function<void(std::shared_ptr<const DrawnOverlay>)>;

  explicit OverlayWorker(Deliver deliver, Draw draw = {});  // no `draw`: uses drawOverlay
  /// Waits for the current picture, which is not delivered.
  ~OverlayWorker();
  OverlayWorker(const OverlayWorker&) = delete;
  OverlayWorker& operator=(const OverlayWorker&) = delete;

  /// Orders a picture; returns at once.
  void ask(OverlayOrder order);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::pictures
