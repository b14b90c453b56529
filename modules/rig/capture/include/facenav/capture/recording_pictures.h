#pragma once
// RecordingPictures: single frames of a recording, in any order (FrameSource plays it from its beginning).

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "facenav/cameras/stereo_frame.h"
#include "facenav/cameras/stereo_rig.h"

namespace facenav::capture {

class RecordingPictures {
 public:
  /// Throws the same Errors as openRecording.
  explicit RecordingPictures(const std::filesystem::path& recording);
  ~RecordingPictures();
  RecordingPictures(RecordingPictures&&) noexcept;
  RecordingPictures& operator=(RecordingPictures&&) noexcept;

  /// Rig of the cameras that took them.
  const cameras::StereoRig& rig() const;
  /// Number of each frame, increasing.
  const std::vector<std::int64_t>& numbers() const;
  const std::vector<double>& times_s() const;
  /// Frame of that number; null if the recording has none. A step forward is fast; with videos, a step back
  /// reads from the beginning. Throws Error if it cannot be read.
  std::shared_ptr<const cameras::StereoFrame> frame(std::int64_t number);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::capture
