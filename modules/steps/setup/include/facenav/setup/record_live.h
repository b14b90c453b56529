#pragma once
// RECORD: writes live cameras (or any other frame source) into a recording folder (resources/doc/formats.md)
// for align, track, calibrate-coil and rig check. Capture times are those of the source. The folder appears
// when it is complete.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "facenav/capture/frame_source.h"
#include "facenav/capture/recording.h"
#include "facenav/core/task_monitor.h"

namespace facenav::steps {

struct RecordRequest {
  std::filesystem::path folder;                           // must not exist, or be empty
  double seconds = 10;                                    // by the capture times
  double frames_per_s = 30;                               // rate of the source, to estimate the disk space
  std::optional<capture::CapturePair> capture = {};       // goes into capture/
  bool keeps_first_as_plain = false;                      // the first pair is the capture's plain pair
  std::size_t most_waiting_bytes = std::size_t(1) << 30;  // limit of pictures that wait for the disk
};

struct RecordOutcome {
  std::int64_t frames = 0;
  std::int64_t left_out = 0;            // pairs lost because the disk was too slow
  double seconds = 0;                   // from the first frame to the last
  double rate = 0;                      // pairs a second
  std::optional<double> right_late_ms;  // median delay of the right picture, if the cameras give it
  std::string missing;                  // pairs that two files lack, with their numbers; empty: none
  std::string ended_by;                 // why it ended early; empty: it did not
  /// Returns "300 pairs in 10.0 s (30.0 a second); ..".
  std::string words() const;
};

/// Records until the time is over, the source ends, a camera fails after the first frame (`ended_by` names
/// it), or `monitor` is cancelled; the recording so far is kept. Throws Error: no frame came, the disk has
/// too little space (before anything is written) or is full (nothing is kept then).
RecordOutcome recordLive(capture::FrameSource& source, const RecordRequest& request, TaskMonitor& monitor);

/// Returns the newest frame of a running source; skips frames captured before the call. Throws Error: the
/// source ended.
cameras::StereoFrame takeStill(capture::FrameSource& source);

}  // namespace facenav::steps
