#pragma once
// AutomaticCapture: the picture for an alignment without a projector. Both cameras see the face and, at rest
// beside it, the coil's marker: its known size tells whether a camera turned since the calibration, which a
// bare face does not show. Takes the picture by itself as soon as all is in view: the mean of some frames in
// which the face does not move. Data flow: stereo frames -> one still pair, in which the alignment measures
// both.

#include <memory>
#include <optional>
#include <string>

#include "facenav/capture/frame_source.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/task_monitor.h"
#include "facenav/face/face_landmarks.h"

namespace facenav::steps {

/// What is looked for in the frames.
struct AutomaticCaptureMethods {
  std::shared_ptr<const face::FaceDetector> face_detector;
  std::unique_ptr<coil_tracking::CoilTracker> coil_tracker;
  coil_tracking::CoilModel coil = coil_tracking::defaultCoil();
};

class AutomaticCapture {
 public:
  AutomaticCapture(const cameras::StereoRig& rig, AutomaticCaptureMethods methods);
  ~AutomaticCapture();
  AutomaticCapture(const AutomaticCapture&) = delete;
  AutomaticCapture& operator=(const AutomaticCapture&) = delete;

  /// In the order of their times. True once the picture is taken; later frames change nothing. Takes
  /// milliseconds, and some tenths of a second for a frame in which the face is looked for.
  bool add(const cameras::StereoFrame& frame);
  /// What is missing, one sentence: what to do. A face that is not found while the marker rests for some
  /// seconds is taken all the same: a mask may hide it. Where the cameras do not expose at the same time, the
  /// face must be at rest, too.
  std::string words() const;
  /// After add() said true.
  const cameras::StereoFrame& still() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// From a source that runs already, within `limit_s` of its frames. `monitor` shows words(). Throws Error
/// with what was missing; Cancelled.
void takeStillCapture(capture::FrameSource& source, AutomaticCapture& still, double limit_s,
                      TaskMonitor& monitor);

}  // namespace facenav::steps
