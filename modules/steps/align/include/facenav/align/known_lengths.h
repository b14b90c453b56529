#pragma once
// Observations of the right camera's pose from a marker of known size (ScaleObservation).

#include <optional>
#include <vector>

#include "facenav/align/align_from_capture.h"
#include "facenav/cameras/stereo_frame.h"
#include "facenav/capture/frame_source.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/registration/aligner.h"

namespace facenav::steps {

/// Message where each camera sees the marker, but together they fit neither calibration nor size.
constexpr const char* kMarkerContradicted =
    "the coil's marker does not fit the cameras' calibration: check the cameras, and the size of the print";

/// True for a face measured in place of a scan while nothing showed whether a camera had turned: its size is
/// then unknown, and a marker does not help to align to it.
inline bool isSizeUnknown(const surface::ScalpSurface& face) {
  return face.measurement && !face.measurement->size;
}
constexpr const char* kSizeUnknown =
    "the stored face was measured without the coil's marker in the picture: align with a projector's dots, "
    "or "
    "measure the face again with the marker beside it";

/// True unless the cameras' time stamps show that the two pictures were taken at different moments.
bool isOfOneMoment(const cameras::StereoFrame& pair);

/// The coil's marker in a still pair.
struct MarkerInPair {
  std::optional<health::ScaleObservation> length;
  bool is_contradicted = false;  // kMarkerContradicted
};

/// Measures the coil's marker in a still pair. No length if it is not seen well in both pictures, or if the
/// cameras' time stamps show different exposure times, because a pair cannot show whether the marker moved in
/// between. The error includes those of print, pictures and calibration.
MarkerInPair markerInPair(const cameras::StereoRig& rig, const cameras::StereoFrame& pair,
                          const coil_tracking::CoilModel& coil, coil_tracking::CoilTracker& tracker);

/// Tracks the marker frame by frame and measures it while it rests.
class RestingMarker {
 public:
  RestingMarker(const cameras::StereoRig& rig, const coil_tracking::CoilModel& coil,
                coil_tracking::CoilTracker& tracker);
  /// Adds a frame; call it in the order of their times. Returns true if the marker is seen at rest.
  bool add(const cameras::StereoFrame& frame);
  /// True if the last frame shows the marker, at rest or not.
  bool isSeen() const { return is_seen_; }
  /// The marker's position in the last frame.
  const std::optional<health::SquareObservation>& last() const { return last_; }
  /// True if, in the last frame, each camera sees a marker but together they do not fit calibration and size.
  bool isContradicted() const { return is_contradicted_; }
  /// Duration of its rest, by the frames' times; 0 while it moves or is not seen.
  double rested_s() const { return rests_since_s_ ? last_s_ - *rests_since_s_ : 0.0; }
  /// Mean over all frames in which it rested; nothing if those are too few.
  std::optional<health::ScaleObservation> length() const;

 private:
  double speed_mm_s(const health::SquareObservation& now, double now_s) const;

  const cameras::StereoRig rig_;
  coil_tracking::CoilTracker& tracker_;
  std::optional<health::SquareObservation> last_;
  double last_s_ = 0;
  bool is_seen_ = false, is_contradicted_ = false;
  std::optional<double> rests_since_s_;
  std::vector<health::ScaleObservation> seen_;
};

/// Measures the resting marker in a film's frames `first` to `last`.
std::optional<health::ScaleObservation> markerLengthIn(capture::FrameSource& film, std::int64_t first,
                                                       std::int64_t last,
                                                       const coil_tracking::CoilModel& coil,
                                                       coil_tracking::CoilTracker& tracker);

/// Turn of the right camera that explains the length.
registration::CameraTurn turnBy(const health::ScaleObservation& length,
                                const registration::TurnableCamera& right);

}  // namespace facenav::steps
