#include "sensor_faults.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "script/script_setting.h"

namespace facenav::room {
namespace {

/// Draws uniformly in 0..1 for one frame; `kind` distinguishes the draws of a frame.
double drawn(const ScenarioOptions& options, std::int64_t frame, std::uint64_t kind) {
  std::mt19937_64 random(options.seed * 9176 + std::uint64_t(frame) * 131 + kind);
  random.discard(3);
  return double(random() >> 11) * 0x1p-53;
}

}  // namespace

double lightTaken(const ScenarioOptions& options, double frame) {
  constexpr double kStep_frames = 5.0;
  if (options.exposure_step == 0.0) return 1.0;
  // Rises in each odd second and falls in each even one, starting at half a second.
  const double in_s = frame / options.frames_per_s + 0.5, second = std::floor(in_s);
  const double since = (in_s - second) * options.frames_per_s / kStep_frames;
  const bool is_up = int(second) % 2 == 1;
  const double level = is_up ? ease(since) : second > 0.0 ? 1.0 - ease(since) : 0.0;
  return 1.0 + options.exposure_step * level;
}

double defocus_px(const ScenarioOptions& options, double frame, int frames) {
  if (options.refocus_px == 0.0 || frames < 2) return 0.0;
  const double part = frame / (frames - 1);
  return options.refocus_px * ease(2.0 * (1.0 - std::abs(6.0 * part - 3.0)));
}

double rightLate_s(const ScenarioOptions& options, double frame) {
  return 1e-3 * options.right_late_ms + 1e-6 * options.clock_ppm * frame / options.frames_per_s;
}

bool isDropped(const ScenarioOptions& options, std::int64_t frame) {
  return frame > 0 && drawn(options, frame, 1) < options.dropped;
}

bool isDoubled(const ScenarioOptions& options, std::int64_t frame) {
  return frame > 0 && drawn(options, frame, 2) < options.doubled;
}

}  // namespace facenav::room
