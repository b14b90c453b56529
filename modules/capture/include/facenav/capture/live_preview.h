#pragma once
// LivePreview: the newest pair of a frame source, read on a thread of its own, to be looked at before
// anything is tracked, and to take the alignment's still pairs from.

#include <memory>
#include <string>

#include "facenav/capture/frame_source.h"

namespace facenav::capture {

class LivePreview {
 public:
  /// `is_paced`: a recording, whose frames come when their time stamps say; cameras pace themselves.
  LivePreview(std::unique_ptr<FrameSource> source, bool is_paced);
  /// Joins after the frame that is being read; the source is released then.
  ~LivePreview();
  LivePreview(const LivePreview&) = delete;
  LivePreview& operator=(const LivePreview&) = delete;

  /// Null before the first.
  std::shared_ptr<const cameras::StereoFrame> latest() const;
  /// Since the newest frame came in, s; large before the first.
  double age_s() const;
  /// Over about the last second; 0 while unknown.
  double frames_per_s() const;
  /// Why no more frames come: an Error in words; empty while all is well.
  std::string failure() const;
  /// A recording has been played to its end.
  bool hasEnded() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::capture
