#pragma once
// FrameSource: a source of stereo frames (recording folder, video pair, camera pair, virtual room). Every
// source implements this interface and passes the contract tests in testing/support/frame_source_contract.h.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::capture {

class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual const cameras::StereoRig& rig() const = 0;
  /// The next frame; null at the end. Frame numbers and time stamps increase. A file source returns frames
  /// without waiting (the session paces them). Throws Error naming the file if a frame cannot be read.
  virtual std::shared_ptr<const cameras::StereoFrame> next() = 0;
  /// Number of frames, if known.
  virtual std::optional<std::int64_t> frameCount() const { return std::nullopt; }
  /// Warnings about live cameras for the user, one line each: "left camera, focus: the camera stays on
  /// automatic". May be called from any thread.
  virtual std::vector<std::string> cautions() const { return {}; }
  /// True if no frame is missed while nobody asks for the next one: files, not live cameras.
  virtual bool isFromFiles() const { return false; }
  /// Pairs of two files that are missing so far, with their numbers, in words; empty if none is. May be
  /// called from any thread.
  virtual std::string missingPairs() const { return {}; }
};

}  // namespace facenav::capture
