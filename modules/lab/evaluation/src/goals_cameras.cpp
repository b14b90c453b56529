#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/evaluation/error_statistics.h"
#include "goal_parts.h"

namespace facenav::evaluation {
namespace {

/// Time (s) from a rotation of 0.05 deg to the frame that reports it; 0 if it was reported before. Nothing if
/// it was not reported, or the camera did not rotate so far.
std::optional<double> lateBy_s(const RunRecord& run) {
  constexpr double kSeen_deg = 0.05;
  const auto noticed = cameraNoticedAt(run);
  if (!noticed) return std::nullopt;
  for (const auto& frame : run.frames)
    if (frame.truth.camera_turn_deg >= kSeen_deg) return std::max(0.0, run.frames[*noticed].t_s - frame.t_s);
  return std::nullopt;
}

/// Goal for a camera that turns or shifts on its mount during the session.
GoalRow driftGoal(const std::vector<Measured>& all) {
  int runs = 0, unnoticed = 0;
  std::size_t wrong = 0, frames = 0;
  double late_s = 0.0, turn_deg = 0.0, loss_s = 0.0;
  for (const auto& one : all) {
    if (one.run->scenario.rfind("drift", 0) != 0 || one.run->frames.empty()) continue;
    ++runs, frames += one.run->frames.size();
    for (const auto& frame : one.frames) wrong += frame.is_head_wrong || frame.is_coil_wrong;
    loss_s = std::max(loss_s, longestLoss_s(*one.run));
    late_s = std::max(late_s, lateBy_s(*one.run).value_or(0.0));
    if (const auto noticed = cameraNoticedAt(*one.run))
      turn_deg = std::max(turn_deg, one.run->frames[*noticed].truth.camera_turn_deg);
    else
      ++unnoticed;
  }
  return {
      "a camera moves on its mount: wrong poses, when noticed",
      "0 wrong; 0.05 deg noticed within 1 s; no loss > 0.2 s",
      formatted("%zu wrong; noticed at %.3f deg or before, at most %.2f s after 0.05 deg, not in %d runs; "
                "longest loss %.2f s",
                wrong, turn_deg, late_s, unnoticed, loss_s),
      verdictOf(wrong == 0 && unnoticed == 0 && late_s <= 1.0 && loss_s <= 0.2, runs > 0),
      basis(runs, frames)};
}

/// Goal for two ordinary USB cameras: tracking of a seated patient and a coil.
GoalRow webcamGoal(const std::vector<Measured>& all, const std::string& scenario) {
  const Pool motion = pool(all, {scenario}, &FrameErrors::motion),
             head = pool(all, {scenario}, &FrameErrors::head),
             coil = pool(all, {scenario}, &FrameErrors::coil);
  std::size_t wrong = 0, frames = 0;
  double loss_s = 0.0;
  std::vector<double> ms;
  for (const auto& one : all) {
    if (one.run->scenario != scenario) continue;
    frames += one.run->frames.size();
    loss_s = std::max(loss_s, longestLoss_s(*one.run));
    for (const auto& frame : one.frames) wrong += frame.is_head_wrong || frame.is_coil_wrong;
    for (const auto& frame : one.run->frames) ms.push_back(frame.head_ms + frame.coil_ms);
  }
  const double moved_mm = summarise(motion.mm).p95, head_mm = summarise(head.mm).p95,
               coil_mm = summarise(coil.mm).p95;
  return {scenario + ": head since the alignment, with it, coil; wrong poses",
          "p95 <= 0.6, <= 1.0, <= 0.5 mm; 0 wrong; no loss > 0.2 s",
          formatted("p95 %.2f, %.2f, %.2f mm; %zu wrong; longest loss %.2f s; median %.2f ms a frame",
                    moved_mm, head_mm, coil_mm, wrong, loss_s, quantile(ms, 0.5)),
          verdictOf(wrong == 0 && moved_mm <= 0.6 && head_mm <= 1.0 && coil_mm <= 0.5 && loss_s <= 0.2,
                    frames > 0),
          basis(motion.runs, frames)};
}

}  // namespace

void addCameraGoals(const std::vector<Measured>& all, std::vector<GoalRow>& rows) {
  for (const char* scenario : {"webcam", "unsynced", "autoexposure", "refocus", "fast_coil", "glasses"})
    rows.push_back(webcamGoal(all, scenario));
  rows.push_back(driftGoal(all));
}

}  // namespace facenav::evaluation
