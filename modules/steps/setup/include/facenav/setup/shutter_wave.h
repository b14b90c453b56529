#pragma once
// ShutterWave: measures the rolling shutter while the coil is waved quickly before the cameras for some
// seconds. A rolling shutter shears and stretches the print of its marker; from that the coil tracker
// estimates the time of a row (CoilResult::row_times_s). Data flow: coil results in the order of their times
// -> row times of both cameras, which are stored with the rig (cameras_learnt.h). Without it a session learns
// them from the first fast coil.

#include <array>
#include <optional>
#include <string>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::steps {

class ShutterWave {
 public:
  explicit ShutterWave(const cameras::StereoRig& rig) : rig_(rig) {}
  /// Adds a result. `seen`: from a tracker that was started with the rig. `now_s`: the frame's time.
  void add(const coil_tracking::CoilResult& seen, double now_s);

  /// True once the row times are known, or after a wave long enough to show a rolling shutter.
  bool isDone() const;
  /// Row times of left and right camera, s from one row to the next; nothing unless isDone() and they differ
  /// from the rig's.
  std::optional<std::array<double, 2>> rowTimes_s() const;
  double progress() const;  // 0..1
  /// What is missing or the result, one sentence.
  std::string words() const;

 private:
  void settle(bool is_quick, double since_s);

  const cameras::StereoRig rig_;
  std::optional<std::array<double, 2>> measured_s_;
  std::optional<std::array<double, 2>> settling_s_;  // values since they changed little
  std::optional<Eigen::Vector3d> last_mm_;           // the marker's position, Camera
  double last_s_ = 0;
  double speed_mm_s_ = 0;             // between the last two frames that show it
  double waved_s_ = 0, posed_s_ = 0;  // duration of quick motion; part of it with a pose
  double known_for_s_ = 0;            // time since the values have settled
  bool is_seen_ = false;
};

}  // namespace facenav::steps
