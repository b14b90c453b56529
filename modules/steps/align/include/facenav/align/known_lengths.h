#pragma once
// What a marker of known size says about the right camera (ScaleObservation).

#include <optional>
#include <vector>

#include "facenav/align/align_from_capture.h"
#include "facenav/cameras/stereo_frame.h"
#include "facenav/capture/frame_source.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/registration/aligner.h"

namespace facenav::steps {

/// Said where each camera sees the marker and together they fit neither calibration nor size.
constexpr const char* kMarkerContradicted =
    "the coil's marker does not fit the cameras' calibration: check the cameras, and the size of the print";

/// A face that cameras measured in place of a scan, while nothing showed whether one of them had turned: then
/// its size is not known, and a marker does not help to align to it.
inline bool isSizeUnknown(const surface::ScalpSurface& face) {
  return face.measurement && !face.measurement->size;
}
constexpr const char* kSizeUnknown =
    "the stored face was measured without the coil's marker in the picture: align with a projector's dots, "
    "or "
    "measure the face again with the marker beside it";

/// False where the cameras' time stamps say that the two pictures are of different moments.
bool isOfOneMoment(const cameras::StereoFrame& pair);

/// What a still pair shows of the coil's marker.
struct MarkerInPair {
  std::optional<health::ScaleObservation> length;
  bool is_contradicted = false;  // kMarkerContradicted
};

/// The coil's marker in a still pair. No length where it is not seen well in both pictures, and where the
/// cameras' time stamps say that they did not expose at the same time: one pair does not tell whether the
/// marker moved in between. The error holds that of the print, of the pictures and of the calibration.
MarkerInPair markerInPair(const cameras::StereoRig& rig, const cameras::StereoFrame& pair,
                          const coil_tracking::CoilModel& coil, coil_tracking::CoilTracker& tracker);

/// Follows the marker frame by frame and measures it while it rests.
class RestingMarker {
 public:
  RestingMarker(const cameras::StereoRig& rig, const coil_tracking::CoilModel& coil,
                coil_tracking::CoilTracker& tracker);
  /// In the order of their times. True where the marker is seen at rest.
  bool add(const cameras::StereoFrame& frame);
  /// In the last frame, whether at rest or not.
  bool isSeen() const { return is_seen_; }
  /// Its place in the last frame.
  const std::optional<health::SquareObservation>& last() const { return last_; }
  /// In the last frame: each camera sees a marker, and together they do not fit calibration and size.
  bool isContradicted() const { return is_contradicted_; }
  /// How long it has rested, by the frames' times; 0 while it moves or is not seen.
  double rested_s() const { return rests_since_s_ ? last_s_ - *rests_since_s_ : 0.0; }
  /// The mean over all frames in which it rested; nothing where those are too few.
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

/// The same of a film's frames `first` to `last`.
std::optional<health::ScaleObservation> markerLengthIn(capture::FrameSource& film, std::int64_t first,
                                                       std::int64_t last,
                                                       const coil_tracking::CoilModel& coil,
                                                       coil_tracking::CoilTracker& tracker);

/// The turn of the right camera that explains it.
registration::CameraTurn turnBy(const health::ScaleObservation& length,
                                const registration::TurnableCamera& right);

}  // namespace facenav::steps
