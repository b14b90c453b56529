#include "commands/camera_print.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace facenav::app {
namespace {

using TrialJson = nlohmann::ordered_json;

void printSide(const char* side, const capture::CameraState& state, const capture::PictureCounts& counts) {
  std::printf("%s: %d x %d px, %s, %.0f pictures a second; time stamps: %s\n", side, state.width_px,
              state.height_px, state.format.c_str(), state.frames_per_s, state.clock.c_str());
  std::printf("  %lld pictures, %lld dropped, %lld damaged, %lld repeated, %lld jumps of the clock\n",
              static_cast<long long>(counts.delivered), static_cast<long long>(counts.dropped),
              static_cast<long long>(counts.damaged), static_cast<long long>(counts.repeated),
              static_cast<long long>(counts.clock_steps));
  for (const auto& control : state.controls) {
    if (control.lock == capture::ControlState::Lock::locked)
      std::printf("  %s locked at %g %s\n", control.name.c_str(), control.actual.value_or(0),
                  control.unit.c_str());
    if (control.lock == capture::ControlState::Lock::refused)
      std::printf("  %s NOT LOCKED: %s\n", control.name.c_str(), control.words.c_str());
  }
  for (const auto& note : state.notes) std::printf("  %s\n", note.c_str());
}

TrialJson sideJson(const capture::CameraState& state, const capture::PictureCounts& counts) {
  static const char* const kLocks[] = {"locked", "absent", "refused"};
  TrialJson controls = TrialJson::array();
  for (const auto& control : state.controls) {
    TrialJson one = {{"name", control.name}, {"unit", control.unit}, {"state", kLocks[int(control.lock)]}};
    if (control.actual) one["value"] = *control.actual;
    if (!control.words.empty()) one["words"] = control.words;
    controls.push_back(one);
  }
  return {
      {"width_px", state.width_px},         {"height_px", state.height_px}, {"format", state.format},
      {"frames_per_s", state.frames_per_s}, {"clock", state.clock},         {"pictures", counts.delivered},
      {"dropped", counts.dropped},          {"damaged", counts.damaged},    {"repeated", counts.repeated},
      {"clock_jumps", counts.clock_steps},  {"adjustments", controls},      {"notes", state.notes}};
}

}  // namespace

void printTrial(const capture::CameraPairSource& source, double rate, double latency_s) {
  const capture::PairTiming timing = source.timing();
  std::printf(
      "%.1f pairs a second; the right picture is %.2f ms later than the left one (+-%.2f ms); without a "
      "partner: %lld "
      "left, %lld right; at most %.0f ms from capture to here\n",
      rate, 1e3 * timing.right_late_s, 1e3 * timing.spread_s, static_cast<long long>(timing.left_alone),
      static_cast<long long>(timing.right_alone), 1e3 * latency_s);
  printSide("left", source.leftState(), source.leftCounts());
  printSide("right", source.rightState(), source.rightCounts());
}

std::string trialJson(const capture::CameraPairSource& source, double rate, double latency_s) {
  const capture::PairTiming timing = source.timing();
  const TrialJson json = {{"pairs_per_s", rate},
                          {"right_late_ms", 1e3 * timing.right_late_s},
                          {"spread_ms", 1e3 * timing.spread_s},
                          {"left_alone", timing.left_alone},
                          {"right_alone", timing.right_alone},
                          {"latency_ms", 1e3 * latency_s},
                          {"left", sideJson(source.leftState(), source.leftCounts())},
                          {"right", sideJson(source.rightState(), source.rightCounts())}};
  return json.dump(1, ' ', false, TrialJson::error_handler_t::replace);
}

}  // namespace facenav::app
