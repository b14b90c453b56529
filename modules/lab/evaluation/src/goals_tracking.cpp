#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/evaluation/error_statistics.h"
#include "goal_parts.h"

namespace facenav::evaluation {
namespace {

constexpr double kNear_mm = 700.0, kTilt_deg = 50.0;  // limits of the coil's stricter goal

GoalRow motionGoal(const char* name, const std::vector<Measured>& all, const Scenarios& scenarios) {
  const Pool p = pool(all, scenarios, &FrameErrors::motion);
  const auto mm = summarise(p.mm), deg = summarise(p.deg);
  return {std::string("head motion since alignment, at the target: ") + name,
          "rms <= 0.3 mm, <= 0.15 deg; p95 <= 0.6 mm",
          formatted("rms %.3f mm, %.3f deg; p95 %.3f, max %.2f mm", mm.rms, deg.rms, mm.p95, mm.max),
          verdictOf(mm.rms <= 0.3 && deg.rms <= 0.15 && mm.p95 <= 0.6, mm.count > 0),
          basis(p.runs, p.mm.size())};
}

GoalRow jitterGoal(const std::vector<Measured>& all) {
  std::vector<double> jitter;
  std::size_t frames = 0;
  for (const auto& one : all)
    if (one.run->scenario == "still" && one.run->frames.size() > 1)
      jitter.push_back(jitter_mm(*one.run)), frames += one.run->frames.size();
  const auto s = summarise(jitter);
  return {"static jitter at the target", "<= 0.05 mm rms",
          formatted("%.3f mm (worst run %.3f)", s.rms, s.max), verdictOf(s.rms <= 0.05, s.count > 0),
          basis(s.count, frames)};
}

GoalRow coilGoal(const std::vector<Measured>& all, bool is_near) {
  const auto takes = [is_near](const RunRecord&, const FrameErrors& frame) {
    return is_near == (frame.coil_distance_mm <= kNear_mm && frame.coil_tilt_deg <= kTilt_deg);
  };
  const Pool p = pool(all, {"coil_sweep"}, &FrameErrors::coil, takes);
  const auto mm = summarise(p.mm), deg = summarise(p.deg);
  const double limit_mm = is_near ? 0.1 : 0.3, limit_deg = is_near ? 0.15 : 0.4;
  return {is_near ? "coil pose, to 700 mm and 50 deg of tilt" : "coil pose, beyond (to 900 mm, 60 deg)",
          formatted("rms <= %.1f mm, %.2f deg", limit_mm, limit_deg),
          formatted("rms %.3f mm, %.3f deg; max %.2f mm, %.2f deg", mm.rms, deg.rms, mm.max, deg.max),
          verdictOf(mm.rms <= limit_mm && deg.rms <= limit_deg, mm.count > 0), basis(p.runs, p.mm.size())};
}

GoalRow markerSeenGoal(const std::vector<Measured>& all) {
  std::size_t in_view = 0, tracked = 0;
  int runs = 0;
  for (const auto& one : all) {
    if (one.run->scenario != "coil_sweep") continue;
    ++runs;
    for (const auto& frame : one.run->frames)
      in_view += frame.is_marker_in_view, tracked += frame.is_marker_in_view && frame.marker;
  }
  const double share = 100.0 * double(tracked) / double(std::max<std::size_t>(1, in_view));
  return {"coil tracked where both cameras show the whole marker (coil sweep)", "(no goal stated)",
          formatted("%.1f %%", share), Verdict::not_measured, basis(runs, in_view)};
}

GoalRow relativeGoal(const std::vector<Measured>& all) {
  const Pool p = pool(all, {"treatment"}, &FrameErrors::relative),
             motion = pool(all, {"treatment"}, &FrameErrors::relative_motion);
  const auto mm = summarise(p.mm), deg = summarise(p.deg);
  return {"coil against head at the target, alignment included", "p95 <= 0.7 mm, 0.4 deg",
          formatted("p95 %.3f mm, %.3f deg (without the alignment's error %.3f mm, %.3f deg)", mm.p95,
                    deg.p95, summarise(motion.mm).p95, summarise(motion.deg).p95),
          verdictOf(mm.p95 <= 0.7 && deg.p95 <= 0.4, mm.count > 0), basis(p.runs, p.mm.size())};
}

GoalRow disturbanceGoal(const std::vector<Measured>& all, const std::string& scenario) {
  const Pool p = pool(all, {scenario}, &FrameErrors::motion);
  double loss_s = 0.0;
  int played = 0, refused = 0;
  for (const auto& one : all) {
    if (one.run->scenario != scenario) continue;
    one.run->frames.empty() ? ++refused : ++played;
    loss_s = std::max(loss_s, longestLoss_s(*one.run));
  }
  const auto mm = summarise(p.mm);
  return {scenario + ": head at the target", "p95 <= 1.0 mm, no loss > 0.2 s",
          formatted("p95 %.3f, max %.2f mm; longest loss %.2f s%s", mm.p95, mm.max, loss_s,
                    refused ? formatted("; %d not aligned", refused).c_str() : ""),
          verdictOf(mm.p95 <= 1.0 && loss_s <= 0.2 && refused == 0, played + refused > 0),
          basis(played + refused, p.mm.size())};
}

}  // namespace

void addTrackingGoals(const std::vector<Measured>& all, std::vector<GoalRow>& rows) {
  rows.push_back(motionGoal("protractor", all, {"protractor"}));
  rows.push_back(motionGoal("free motion", all, {"free_motion"}));
  rows.push_back(jitterGoal(all));
  rows.push_back(coilGoal(all, true));
  rows.push_back(coilGoal(all, false));
  rows.push_back(markerSeenGoal(all));
  rows.push_back(relativeGoal(all));
  for (const char* scenario : {"talking", "occlusion", "lighting", "glint", "mask", "mask_on"})
    rows.push_back(disturbanceGoal(all, scenario));
}

}  // namespace facenav::evaluation
