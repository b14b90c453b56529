#include "facenav/setup/shutter_wave.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/setup/cameras_learnt.h"

namespace facenav::steps {
namespace {

// Smallest speed of a wave, by choice: a hand waves a coil at 200 to 400 mm/s without effort, and the tracker
// learns from 80 mm/s on.
constexpr double kQuick_mm_s = 150;
constexpr double kLongestGap_s = 0.25;  // longer times between frames are not counted
constexpr double kEnough_s = 6.0;       // duration of waving after which there is no rolling shutter
constexpr double kSettles_s = 1.0;      // duration of waving in which the times must not change
constexpr double kInStepShare = 0.5;    // smallest share of waved frames with a pose, if the pair is in step
constexpr double kStays_s = 1e-3;       // of a whole picture: moves a coil of 500 mm/s by 0.25 mm at most

}  // namespace

void ShutterWave::add(const coil_tracking::CoilResult& seen, double now_s) {
  const double since_s = now_s - last_s_;
  const bool is_next = since_s > 0 && since_s < kLongestGap_s;
  // A quick coil may have no pose while the row times are unknown.
  const bool has_no_pose_yet =
      !seen && (seen.reason() == LostReason::camera || seen.reason() == LostReason::high_residual);
  is_seen_ = seen || has_no_pose_yet;
  if (seen) {
    const Eigen::Vector3d now_mm = seen->camera_T_marker.translation_mm();
    if (last_mm_ && is_next) speed_mm_s_ = (now_mm - *last_mm_).norm() / since_s;
    last_mm_ = now_mm;
  }
  if (!is_seen_) last_mm_.reset(), speed_mm_s_ = 0;
  last_s_ = now_s;
  if (isDone()) return;
  const bool is_quick = is_seen_ && is_next && (has_no_pose_yet || speed_mm_s_ >= kQuick_mm_s);
  if (is_quick) waved_s_ += since_s;
  if (is_quick && seen) posed_s_ += since_s;
  measured_s_ = otherRowTimes(seen.row_times_s, rig_);
  settle(is_quick, since_s);
}

/// Waits until the times settle: the first frames are fitted with a wrong row time, and one bad frame
/// falsifies the next ones.
void ShutterWave::settle(bool is_quick, double since_s) {
  const auto stays = [&](std::size_t side) {
    return std::abs((*measured_s_)[side] - (*settling_s_)[side]) * rig_.height_px < kStays_s;
  };
  if (!measured_s_ || !settling_s_ || !stays(0) || !stays(1)) {
    settling_s_ = measured_s_;
    known_for_s_ = 0;
  } else if (is_quick) {
    known_for_s_ += since_s;
  }
}

bool ShutterWave::isDone() const { return measured_s_ ? known_for_s_ >= kSettles_s : waved_s_ >= kEnough_s; }

std::optional<std::array<double, 2>> ShutterWave::rowTimes_s() const {
  return isDone() ? measured_s_ : std::nullopt;
}

double ShutterWave::progress() const {
  if (isDone()) return 1.0;
  const double share = measured_s_ ? 0.5 + 0.5 * known_for_s_ / kSettles_s : 0.9 * waved_s_ / kEnough_s;
  return std::clamp(share, 0.0, 1.0);
}

std::string ShutterWave::words() const {
  const auto readout_ms = [&](double row_s) { return 1e3 * row_s * rig_.height_px; };
  if (isDone() && measured_s_)
    return formatted(
        "the shutter is known: a picture is read in %.0f ms by the left camera, in %.0f ms by the right",
        readout_ms((*measured_s_)[0]), readout_ms((*measured_s_)[1]));
  // The pictures are of two moments if a quick coil has no pose in most frames.
  if (isDone() && posed_s_ < kInStepShare * waved_s_)
    return "the waved coil is hardly ever in one place for both cameras: they do not expose at the same "
           "time; "
           "a session allows for that, by the moving head";
  if (isDone())
    return rig_.left.row_time_s == 0 && rig_.right.row_time_s == 0
               ? "no delay between the rows shows: these cameras need no correction"
               : "the rows are read as this pair states: nothing changes";
  if (!is_seen_) return "hold the coil so that both cameras see its marker, and wave it";
  if (speed_mm_s_ < kQuick_mm_s)
    return formatted(
        "wave the coil quicker, to and fro and up and down, its marker to both cameras (%.0f of %.0f cm a "
        "second)",
        speed_mm_s_ / 10, kQuick_mm_s / 10);
  return "good: wave on, its marker to both cameras";
}

}  // namespace facenav::steps
