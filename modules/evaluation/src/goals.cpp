#include "facenav/evaluation/goals.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "facenav/core/number_text.h"
#include "facenav/evaluation/error_statistics.h"
#include "facenav/evaluation/frame_errors.h"
#include "facenav/geometry/rotation.h"

namespace facenav::evaluation {
namespace {

constexpr double kNear_mm = 700.0, kTilt_deg = 50.0;  // limits of the coil's stricter goal

/// Runs with the errors of their frames, computed once.
struct Measured {
  const RunRecord* run;
  std::vector<FrameErrors> frames;
};

std::string basis(int runs, std::size_t frames) { return formatted("%d runs, %zu frames", runs, frames); }

using Scenarios = std::set<std::string>;

/// The errors of one kind, over all frames of some scenarios that `takes` selects.
struct Pool {
  std::vector<double> mm, deg;
  int runs = 0;
};
Pool pool(const std::vector<Measured>& all, const Scenarios& scenarios,
          std::optional<ErrorAt> FrameErrors::*which,
          const std::function<bool(const RunRecord&, const FrameErrors&)>& takes = {}) {
  Pool result;
  for (const Measured& one : all) {
    if (!scenarios.empty() && !scenarios.count(one.run->scenario)) continue;
    const std::size_t before = result.mm.size();
    for (const FrameErrors& frame : one.frames)
      if (frame.*which && (!takes || takes(*one.run, frame)))
        result.mm.push_back((frame.*which)->mm), result.deg.push_back((frame.*which)->deg);
    result.runs += result.mm.size() > before;
  }
  return result;
}

Verdict verdictOf(bool is_met, bool is_measured) {
  return !is_measured ? Verdict::not_measured : is_met ? Verdict::met : Verdict::missed;
}

/// Their capture is also a coarse JPEG, but the goal of the face cloud is for cameras without compression.
const Scenarios& compressedScenarios() {
  static const Scenarios names{"grimace",     "grimace_other", "returns",
                               "out_of_step", "moments",       "moments_other"};
  return names;
}

GoalRow cloudGoal(const std::vector<Measured>& all) {
  std::vector<double> rms, predicted, coverage, gross;
  for (const auto& one : all)
    if (one.run->cloud && one.run->from.empty() && !one.run->is_capture_repeated &&
        !compressedScenarios().count(one.run->scenario)) {
      rms.push_back(one.run->cloud->rms_mm);
      predicted.push_back(one.run->cloud->predicted_mm);
      coverage.push_back(one.run->cloud->coverage_percent);
      gross.push_back(one.run->cloud->gross_percent);
    }
  const auto r = summarise(rms), c = summarise(coverage);
  return {"face cloud, along the ray; share of the visible face", "rms <= 0.18 mm, >= 98 %",
          formatted("%.3f mm (worst run %.3f; the images' noise allows %.3f), %.1f %%; %.2f %% gross", r.rms,
                    r.max, summarise(predicted).rms, c.mean, summarise(gross).mean),
          verdictOf(r.rms <= 0.18 && c.mean >= 98.0, r.count > 0), formatted("%d captures", r.count)};
}

struct AlignmentErrors {
  std::vector<double> mm, deg;
  int inside = 0, refused = 0;
};
AlignmentErrors alignmentErrors(const std::vector<Measured>& all,
                                const std::function<bool(const RunRecord&)>& takes) {
  AlignmentErrors errors;
  for (const auto& one : all) {
    const RunRecord& run = *one.run;
    if (!run.alignment || run.is_capture_repeated || run.must_be_refused || !takes(run) ||
        run.scenario == "mask")
      continue;  // a capture with a mask may be refused: that sequence has its own row
    const AlignmentRecord& a = *run.alignment;
    if (!a.refusal.empty()) {
      ++errors.refused;
      continue;
    }
    errors.mm.push_back((a.estimated * run.target_mm - a.truth * run.target_mm).norm());
    errors.deg.push_back(kDegPerRad * rotationAngle(a.estimated.linear().transpose() * a.truth.linear()));
    errors.inside += errors.mm.back() <= a.bound95_mm;
  }
  return errors;
}

GoalRow alignmentGoal(const char* of, const std::vector<Measured>& all,
                      const std::function<bool(const RunRecord&)>& takes, double median_mm, double max_mm,
                      double max_deg, const std::string& goal) {
  const auto errors = alignmentErrors(all, takes);
  const auto mm = summarise(errors.mm), deg = summarise(errors.deg);
  return {std::string("alignment at the cortical target, ") + of, goal,
          formatted("median %.2f, p95 %.2f, max %.2f mm; max %.2f deg; %d refused", mm.median, mm.p95, mm.max,
                    deg.max, errors.refused),
          verdictOf(mm.median <= median_mm && mm.max <= max_mm && deg.max <= max_deg && errors.refused == 0,
                    mm.count + errors.refused > 0),
          formatted("%d captures", mm.count + errors.refused)};
}

GoalRow boundGoal(const std::vector<Measured>& all, const std::string& from) {
  const auto errors = alignmentErrors(all, [&](const RunRecord& run) { return run.from == from; });
  const double share = 100.0 * errors.inside / std::max<std::size_t>(1, errors.mm.size());
  return {"alignment" + (from.empty() ? "" : " from " + from) + ": true error inside the stated 95 % bound",
          "95 %", formatted("%.0f %%", share), verdictOf(share >= 95.0, !errors.mm.empty()),
          formatted("%zu captures", errors.mm.size())};
}

/// A camera that turned about its vertical axis leaves every match on its epipolar line.
GoalRow turnedGoal(const std::vector<Measured>& all) {
  const auto errors = alignmentErrors(
      all, [](const RunRecord& run) { return run.from.find("turned sideways") != std::string::npos; });
  const int accepted = int(errors.mm.size()), outside = accepted - errors.inside;
  return {"aligned with a camera turned sideways by 0.05-0.3 deg: outside the stated bound", "0",
          formatted("%d of %d accepted, max %.2f mm; %d refused", outside, accepted, summarise(errors.mm).max,
                    errors.refused),
          verdictOf(outside == 0, accepted + errors.refused > 0),
          formatted("%d attempts", accepted + errors.refused)};
}

/// One patient aligned in several ways: errors and bound of each, and what must be refused.
void addWays(const std::vector<Measured>& all, std::vector<GoalRow>& rows) {
  int tried = 0, accepted = 0;
  for (const Measured& one : all) {
    if (!one.run->must_be_refused || !one.run->alignment || one.run->from.rfind("plain", 0) != 0) continue;
    ++tried;
    accepted += one.run->alignment->refusal.empty();
  }
  for (const char* from : {"dots", "sparse dots", "plain", "film"}) {
    const auto is_from = [from](const RunRecord& run) { return run.from == from; };
    rows.push_back(alignmentGoal(("from " + std::string(from)).c_str(), all, is_from, 0.5, 1.0, 0.5,
                                 "median <= 0.5, max <= 1.0 mm, <= 0.5 deg"));
    rows.push_back(boundGoal(all, from));
  }
  rows.push_back(turnedGoal(all));
  rows.push_back({"aligned from a plain pair: another's scan, a mirrored one, moved cameras", "0",
                  formatted("%d of %d", accepted, tried), verdictOf(accepted == 0, tried > 0),
                  formatted("%d attempts", tried)});
}

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

GoalRow wrongGoal(const std::vector<Measured>& all) {
  std::size_t head = 0, coil = 0, frames = 0;
  int runs = 0;
  for (const auto& one : all) {
    runs += !one.frames.empty();
    frames += one.frames.size();
    for (const auto& frame : one.frames) head += frame.is_head_wrong, coil += frame.is_coil_wrong;
  }
  return {"wrong poses shown as tracked (> 3 mm or > 2 deg), all scenarios", "0",
          formatted("head %zu, coil %zu", head, coil), verdictOf(head + coil == 0, frames > 0),
          basis(runs, frames)};
}

GoalRow foundAgainGoal(const std::vector<Measured>& all) {
  std::vector<double> times_s;
  int runs = 0;
  for (const auto& one : all) {
    const auto of_run = timesToFindAgain_s(*one.run);
    runs += !of_run.empty();
    times_s.insert(times_s.end(), of_run.begin(), of_run.end());
  }
  const auto s = summarise(times_s);
  return {"found again after a loss", "<= 0.2 s", formatted("median %.3f, max %.3f s", s.median, s.max),
          verdictOf(s.max <= 0.2, s.count > 0), formatted("%d losses in %d runs", s.count, runs)};
}

GoalRow returnsGoal(const char* quantity, const std::vector<Measured>& all, const Scenarios& scenarios) {
  constexpr double kAtOnce_s = 0.2;
  int returns = 0, found = 0, runs = 0;
  for (const auto& one : all) {
    if (!scenarios.count(one.run->scenario)) continue;
    ++runs;
    for (const double waited_s : timesToFindAgain_s(*one.run)) ++returns, found += waited_s <= kAtOnce_s;
  }
  return {quantity, ">= 95 %", formatted("%d of %d", found, returns),
          verdictOf(found >= 0.95 * returns, returns > 0), formatted("%d runs", runs)};
}

/// Counts frames with a head pose, among the frames of some scenarios that `counts` selects.
GoalRow neverShownGoal(const char* quantity, const std::vector<Measured>& all, const Scenarios& scenarios,
                       const std::function<bool(const FrameTruth&)>& counts) {
  std::size_t frames = 0, shown = 0;
  int runs = 0;
  for (const auto& one : all) {
    if (!scenarios.count(one.run->scenario)) continue;
    ++runs;
    for (const auto& frame : one.run->frames)
      if (counts(frame.truth)) ++frames, shown += frame.head_motion.has_value();
  }
  return {quantity, "0", formatted("%zu of %zu frames", shown, frames), verdictOf(shown == 0, frames > 0),
          basis(runs, frames)};
}

/// Time (s) from a turn of 0.05 deg to the frame that says so; 0: it was said before. Nothing: it was not
/// said, or the camera did not turn so far.
std::optional<double> lateBy_s(const RunRecord& run) {
  constexpr double kSeen_deg = 0.05;
  const auto noticed = cameraNoticedAt(run);
  if (!noticed) return std::nullopt;
  for (const auto& frame : run.frames)
    if (frame.truth.camera_turn_deg >= kSeen_deg) return std::max(0.0, run.frames[*noticed].t_s - frame.t_s);
  return std::nullopt;
}

/// A camera that turns or shifts on its mount during the session.
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

GoalRow timeGoal(const std::vector<Measured>& all) {
  std::vector<double> both, head, coil;
  for (const auto& one : all)
    for (const auto& frame : one.run->frames) {
      head.push_back(frame.head_ms);
      coil.push_back(frame.coil_ms);
      both.push_back(frame.head_ms + frame.coil_ms);
    }
  const double median = quantile(both, 0.5), p99 = quantile(both, 0.99);
  return {"processor time a stereo frame, head and coil, one core", "median <= 3 ms, p99 <= 6 ms",
          formatted("median %.2f (head %.2f, coil %.2f), p99 %.2f ms", median, quantile(head, 0.5),
                    quantile(coil, 0.5), p99),
          verdictOf(median <= 3.0 && p99 <= 6.0, !both.empty()), formatted("%zu frames", both.size())};
}

}  // namespace

std::vector<GoalRow> judge(const std::vector<RunRecord>& runs) {
  std::vector<Measured> all;
  for (const auto& run : runs) all.push_back({&run, frameErrors(run)});
  std::vector<GoalRow> rows{cloudGoal(all)};
  const auto isDeveloped = [](const RunRecord& run) {
    return run.from.empty() && !run.is_unseen_head && !run.is_scan_cut;
  };
  const auto isUnseen = [](const RunRecord& run) {
    return run.from.empty() && run.is_unseen_head && !run.is_scan_cut;
  };
  const auto isCut = [](const RunRecord& run) { return run.from.empty() && run.is_scan_cut; };
  rows.push_back(alignmentGoal("development head", all, isDeveloped, 0.5, 1.0, 0.3,
                               "median <= 0.5, max <= 1.0 mm, <= 0.3 deg"));
  rows.push_back(alignmentGoal("unseen heads", all, isUnseen, 1.0, 1.0, 0.5, "<= 1.0 mm, <= 0.5 deg"));
  rows.push_back(alignmentGoal("scans that end above the chin", all, isCut, 2.0, 2.0, 90.0, "<= 2 mm"));
  rows.push_back(boundGoal(all, ""));
  addWays(all, rows);
  rows.push_back(motionGoal("protractor", all, {"protractor"}));
  rows.push_back(motionGoal("free motion", all, {"free_motion"}));
  rows.push_back(jitterGoal(all));
  rows.push_back(coilGoal(all, true));
  rows.push_back(coilGoal(all, false));
  rows.push_back(markerSeenGoal(all));
  rows.push_back(relativeGoal(all));
  for (const char* scenario : {"talking", "occlusion", "lighting", "glint", "mask", "mask_on"})
    rows.push_back(disturbanceGoal(all, scenario));
  rows.push_back(driftGoal(all));
  rows.push_back(wrongGoal(all));
  rows.push_back(foundAgainGoal(all));
  rows.push_back(
      returnsGoal("back with another grimace: found within 0.2 s", all, {"grimace", "grimace_other"}));
  rows.push_back(
      returnsGoal("back as a real face shows itself: found within 0.2 s", all, {"moments", "moments_other"}));
  rows.push_back(neverShownGoal("another person shown as the patient", all,
                                {"other_face", "grimace_other", "moments_other"},
                                [](const FrameTruth& truth) { return !truth.head; }));
  rows.push_back(neverShownGoal("a pose shown while the cameras are out of step", all, {"out_of_step"},
                                [](const FrameTruth& truth) { return truth.must_be_lost; }));
  rows.push_back(timeGoal(all));
  return rows;
}

std::string inWords(Verdict verdict) {
  switch (verdict) {
    case Verdict::met:
      return "met";
    case Verdict::missed:
      return "MISSED";
    default:
      return "-";
  }
}

}  // namespace facenav::evaluation
