#include <algorithm>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/evaluation/error_statistics.h"
#include "facenav/geometry/rotation.h"
#include "goal_parts.h"

namespace facenav::evaluation {
namespace {

/// Scenarios whose capture is a coarse JPEG; the goal of the face cloud is for cameras without compression.
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
  // The shown error is that of a coil on the target if that was tried, else that of the point.
  std::vector<double> shown_mm, bound_mm;
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
    errors.shown_mm.push_back(a.coil_mm.value_or(errors.mm.back()));
    errors.bound_mm.push_back(a.coil_mm ? a.coil_bound95_mm : a.bound95_mm);
    errors.inside += errors.shown_mm.back() <= errors.bound_mm.back();
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
  const auto shown = summarise(errors.shown_mm), bound = summarise(errors.bound_mm);
  return {from.empty() ? "alignment: true error inside the stated 95 % bound"
                       : "coil on the target, alignment from " + from + ": inside the stated 95 % bound",
          "95 %",
          formatted("%.0f %%: median %.2f, max %.2f mm; stated median %.2f, max %.2f mm", share, shown.median,
                    shown.max, bound.median, bound.max),
          verdictOf(share >= 95.0, !errors.mm.empty()), formatted("%zu captures", errors.mm.size())};
}

/// Goal for a camera rotated about its vertical axis, which leaves every match on its epipolar line.
GoalRow turnedGoal(const std::vector<Measured>& all) {
  const auto errors = alignmentErrors(
      all, [](const RunRecord& run) { return run.from.find("turned sideways") != std::string::npos; });
  const int accepted = int(errors.mm.size()), outside = accepted - errors.inside;
  return {"coil on the target, a camera turned sideways by 0.05-0.3 deg before: outside the stated bound",
          "0",
          formatted("%d of %d accepted, max %.2f mm; %d refused", outside, accepted,
                    summarise(errors.shown_mm).max, errors.refused),
          verdictOf(outside == 0, accepted + errors.refused > 0),
          formatted("%d attempts", accepted + errors.refused)};
}

/// Adds rows for one patient aligned in several ways: errors and bound of each, and what must be refused.
void addWays(const std::vector<Measured>& all, std::vector<GoalRow>& rows) {
  int tried = 0, accepted = 0;
  for (const Measured& one : all) {
    if (!one.run->must_be_refused || !one.run->alignment || one.run->from.rfind("plain", 0) != 0) continue;
    ++tried;
    accepted += one.run->alignment->refusal.empty();
  }
  for (const char* from : {"dots", "dots and marker", "sparse dots", "plain", "plain and marker", "film"}) {
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

}  // namespace

void addAlignmentGoals(const std::vector<Measured>& all, std::vector<GoalRow>& rows) {
  rows.push_back(cloudGoal(all));
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
}

}  // namespace facenav::evaluation
