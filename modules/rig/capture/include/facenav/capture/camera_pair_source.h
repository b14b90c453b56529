#pragma once
// A live pair of cameras as a FrameSource. Each camera is read on its own thread; pairs are made by capture
// time (picture_matcher.h), not by arrival. A frame's `captured` is the left camera's time, its
// `right_late_s` the right camera's delay. A slow reader misses pairs, but never gets old ones. Two files or
// folders are read pair by pair instead: none is missed, and missing partners are named (src/file_pair.h).

#include <memory>

#include "facenav/capture/camera.h"
#include "facenav/capture/frame_source.h"
#include "facenav/capture/picture_matcher.h"

namespace facenav::capture {

struct PairSettings {
  CameraSettings left, right;  // their size is replaced by the rig's
  double patience_s = 2.0;     // after this time without a pair, next() reports which camera is silent
};

class CameraPairSource : public FrameSource {
 public:
  /// Statistics of the pairing since the start.
  virtual PairTiming timing() const = 0;
  virtual PictureCounts leftCounts() const = 0;
  virtual PictureCounts rightCounts() const = 0;
  /// State as read back from the cameras.
  virtual CameraState leftState() const = 0;
  virtual CameraState rightState() const = 0;
};

/// Configures and starts both cameras. Throws CameraError naming the camera; so does next(): unplugged, hung.
std::unique_ptr<CameraPairSource> openCameraPair(const cameras::StereoRig& rig, std::unique_ptr<Camera> left,
                                                 std::unique_ptr<Camera> right,
                                                 const PairSettings& settings = {});

}  // namespace facenav::capture
