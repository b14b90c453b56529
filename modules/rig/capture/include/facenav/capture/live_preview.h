#pragma once
// LivePreview: reads a frame source on its own thread and keeps the newest pair. It shows the cameras before
// tracking starts, and provides the still pairs for the alignment.

#include <memory>
#include <string>

#include "facenav/capture/frame_source.h"

namespace facenav::capture {

class LivePreview {
 public:
  /// `is_paced`: true for a recording, whose frames are delivered at their time stamps; cameras set their own
  /// pace.
  LivePreview(std::unique_ptr<FrameSource> source, bool is_paced);
  /// Waits for the frame that is being read, then releases the source.
  ~LivePreview();
  LivePreview(const LivePreview&) = delete;
  LivePreview& operator=(const LivePreview&) = delete;

  /// Newest frame; null before the first one.
  std::shared_ptr<const cameras::StereoFrame> latest() const;
  /// Time since the newest frame, s; large before the first frame.
  double age_s() const;
  /// Frame rate over about the last second; 0 while unknown.
  double frames_per_s() const;
  /// Reason why no more frames arrive (the message of an Error); empty while there is no failure.
  std::string failure() const;
  /// Warnings of the source (FrameSource::cautions).
  std::vector<std::string> cautions() const;
  /// True when a recording has been played to its end.
  bool hasEnded() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace facenav::capture
