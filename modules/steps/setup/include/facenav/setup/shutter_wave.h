#pragma once
// ShutterWave: the coil is waved quickly before the cameras for some seconds. A rolling shutter shears and
// stretches the print of its marker, and the coil tracker tells the time of a row from it
// (CoilResult::row_times_s). Data flow: coil results in the order of their times -> row times of both
// cameras, which are kept with the rig (cameras_learnt.h). Without it a session learns them from the first
// fast coil.

#include <array>
#include <optional>
#include <string>

#include "facenav/cameras/stereo_rig.h"
#include "facenav/coil_tracking/coil_tracker.h"

namespace facenav::steps {

class ShutterWave {
 public:
  explicit ShutterWave(const cameras::StereoRig& rig) : rig_(rig) {}
  /// `seen`: of a tracker that was started with the rig. `now_s`: the frame's time.
  void add(const coil_tracking::CoilResult& seen, double now_s);

  /// True once the row times are known, or after so long a wave that a rolling shutter would have shown.
  bool isDone() const;
  /// Left and right, s from one row to the row below; nothing unless isDone() and they differ from the rig's.
  std::optional<std::array<double, 2>> rowTimes_s() const;
  double progress() const;  // 0..1
  /// What is missing or what was found, one sentence.
  std::string words() const;

 private:
  void settle(bool is_quick, double since_s);

  const cameras::StereoRig rig_;
  std::optional<std::array<double, 2>> measured_s_;
  std::optional<std::array<double, 2>> settling_s_;  // since they changed little
  std::optional<Eigen::Vector3d> last_mm_;           // the marker, Camera
  double last_s_ = 0;
  double speed_mm_s_ = 0;             // of the last two frames that show it
  double waved_s_ = 0, posed_s_ = 0;  // how long it was quick; of that, with a pose
  double known_for_s_ = 0;            // since the times have settled
  bool is_seen_ = false;
};

}  // namespace facenav::steps
