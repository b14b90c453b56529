#pragma once
// FrameSource: where stereo frames come from (recording folder, video pair, camera pair, virtual room). The
// interface every source implements; testing/support/frame_source_contract.h holds its contract tests.

#include <memory>
#include <optional>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::capture {

class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual const cameras::StereoRig& rig() const = 0;
  /// The next frame, numbers rising, time stamps rising; null at the end. A file source returns frames as
  /// fast as they are asked for (the session paces them). Throws Error naming the file when a frame cannot be
  /// read.
  virtual std::shared_ptr<const cameras::StereoFrame> next() = 0;
  /// Number of frames, where known.
  virtual std::optional<std::int64_t> frameCount() const { return std::nullopt; }
};

}  // namespace facenav::capture
