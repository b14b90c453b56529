#pragma once
// AutomaticCapture: takes the picture for an alignment without a projector. Both cameras see the face and, at
// rest beside it, the coil's marker. The marker's known size measures a camera's turn since the calibration,
// which a bare face does not show. The picture is taken as soon as all is in view: the mean of some frames in
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

/// Methods that search the frames.
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

  /// Adds a frame; call it in the order of their times. Returns true once the picture is taken; later frames
  /// change nothing. Takes milliseconds, and some tenths of a second for a frame in which the face is
  /// searched.
  bool add(const cameras::StereoFrame& frame);
  /// Says what is missing and what to do, in one sentence. If the face is not found while the marker rests
  /// for some seconds, the picture is taken nevertheless, because a mask may hide the face. If the cameras do
  /// not expose at the same time, the face must be at rest, too.
  std::string words() const;
  /// The picture; only after add() returned true.
  const cameras::StereoFrame& still() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Takes the picture from a running source, within `limit_s` of its frames. `monitor` shows words(). Throws
/// Error with what was missing; Cancelled.
void takeStillCapture(capture::FrameSource& source, AutomaticCapture& still, double limit_s,
                      TaskMonitor& monitor);

}  // namespace facenav::steps
