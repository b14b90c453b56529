#include "facenav/session/pulse_pose.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"
#include "facenav/geometry/interpolate.h"
#include "facenav/geometry/rotation.h"
#include "facenav/guidance/handle.h"
#include "facenav/session/navigator.h"

namespace facenav::session {
namespace {

/// Returns the title of a loss without the advice: "FACE NOT FOUND: turn the face .." -> "face not found".
std::string titleOf(const std::string& words) {
  std::string title = words.substr(0, words.find(':'));
  std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) { return std::tolower(c); });
  return title;
}

std::string outsideWords(const guidance::GuidanceValues& values, const guidance::Tolerance& tolerance) {
  std::string words;
  const auto add = [&](bool is_outside, const std::string& what) {
    if (is_outside) words += (words.empty() ? "" : "; ") + what;
  };
  add(values.lateral_mm > tolerance.lateral_mm,
      formatted("%.1f mm beside the target (%.1f allowed)", values.lateral_mm, tolerance.lateral_mm));
  add(std::abs(values.depth_mm) > tolerance.depth_mm,
      formatted("%.1f mm too %s (%.1f allowed)", std::abs(values.depth_mm),
                values.depth_mm > 0 ? "deep" : "high", tolerance.depth_mm));
  add(values.tilt_rad > tolerance.tilt_rad,
      formatted("tilted by %.1f deg (%.1f allowed)", values.tilt_rad * kDegPerRad,
                tolerance.tilt_rad * kDegPerRad));
  add(std::abs(values.twist_rad) > tolerance.twist_rad,
      formatted("turned by %.1f deg (%.1f allowed)", std::abs(values.twist_rad) * kDegPerRad,
                tolerance.twist_rad * kDegPerRad));
  return words;
}

/// Reason why interpolation is impossible; empty: it is possible.
std::string missingFrames(const std::optional<PosedFrame>& before, const std::optional<PosedFrame>& after) {
  if (!before) return "no picture before the pulse";
  if (!after) return formatted("no picture within %.1f s after the pulse", kLongestWait_s);
  const double between_s = after->taken - before->taken;
  if (before->coil != after->coil) return "another coil was chosen at that moment";
  if (between_s > kLongestBetweenFrames_s) return formatted("no picture for %.2f s", between_s);
  return {};
}

/// Reason why the frame has no pose of the pulse's coil; empty: it has, or there is no frame.
std::string otherCoil(const PulseTrigger& trigger, const std::optional<PosedFrame>& frame,
                      const std::optional<PosedFrame>& of_coil) {
  if (!frame || of_coil) return {};
  if (trigger.coil.empty()) return "it is not known which of the two coils gave it";
  return "the coil '" + trigger.coil + "' was not followed";
}

std::optional<double> sourceTime_s(Timestamp at, const std::optional<PosedFrame>& before,
                                   const std::optional<PosedFrame>& after, double fraction) {
  if (before && after) return (1.0 - fraction) * before->captured.s + fraction * after->captured.s;
  if (before) return before->captured.s + (at - before->taken);
  if (after) return after->captured.s - (after->taken - at);
  return std::nullopt;
}

template <class Pose>
std::optional<Pose> between(const std::optional<Pose>& a, const std::optional<Pose>& b, double fraction) {
  if (!a || !b) return std::nullopt;
  return interpolated(*a, *b, fraction);
}

/// Describes why a pulse is doubtful although the coil is on target.
std::string doubtWords(const casefile::Pulse& pulse, const ChosenTarget& chosen) {
  std::string words;
  const double planned_mm = guidance::centreGap_mm(chosen.target);
  if (pulse.gap_mm && *pulse.gap_mm > planned_mm + kMostGapBeyondPlan_mm)
    words = formatted("gap of %.1f mm to the skin (%.1f planned, %.1f more allowed)", *pulse.gap_mm,
                      planned_mm, kMostGapBeyondPlan_mm);
  const std::string uncertain = tooUncertainInWords(chosen);
  if (!uncertain.empty()) words += (words.empty() ? "" : "; ") + uncertain;
  return words;
}

void judge(casefile::Pulse& pulse, const PosedFrame& frame) {
  if (!frame.chosen) {
    pulse.status = casefile::PulseStatus::outside;
    pulse.reason = "no target was chosen";
    return;
  }
  const auto values = guidance::evaluate(frame.chosen->target, *pulse.mri_T_coil());
  pulse.offset = {values.distance_mm, values.lateral_mm, values.depth_mm, values.tilt_rad * kDegPerRad,
                  values.twist_rad * kDegPerRad};
  pulse.reason = outsideWords(values, frame.tolerance);
  if (pulse.reason.empty()) pulse.reason = doubtWords(pulse, *frame.chosen);
  pulse.status = pulse.reason.empty() ? casefile::PulseStatus::on_target : casefile::PulseStatus::outside;
}

/// Marks a pulse that was given in a pause: nobody was guided then, so that it is never on target.
void markPause(casefile::Pulse& pulse) {
  if (!pulse.is_in_pause) return;
  pulse.reason = pulse.reason.empty() ? "given in a pause" : "given in a pause; " + pulse.reason;
  if (pulse.status == casefile::PulseStatus::on_target) pulse.status = casefile::PulseStatus::outside;
}

/// Fills what does not depend on the poses; `known`: the frame before, else the one after; may be null.
void describe(const PulseTrigger& trigger, const PosedFrame* known, casefile::Pulse& pulse) {
  pulse.steady_s = trigger.at.s;
  pulse.utc = isoUtc(trigger.utc);
  pulse.source = trigger.source;
  pulse.intensity_pct = trigger.intensity_pct;
  pulse.is_in_pause = trigger.is_in_pause;
  pulse.coil = trigger.coil;
  if (!known) return;
  pulse.coil = known->coil;
  if (!known->chosen) return;
  pulse.target = known->chosen->target;
  pulse.target->note.clear();
  if (known->chosen->predicted_error_mm > 0) pulse.predicted_error_mm = known->chosen->predicted_error_mm;
  if (known->chosen->error_bound_mm > 0) pulse.error_bound_mm = known->chosen->error_bound_mm;
}

/// Interpolates the poses and judges the pulse; what it lacks is its reason.
void place(const PosedFrame& before, const PosedFrame& after, const registration::ScalpField* scalp,
           casefile::Pulse& pulse) {
  pulse.frames = {before.frame, after.frame};
  pulse.camera_T_mri = between(before.camera_T_mri, after.camera_T_mri, pulse.fraction);
  pulse.camera_T_coil = between(before.camera_T_coil, after.camera_T_coil, pulse.fraction);
  if (pulse.camera_T_mri && pulse.camera_T_coil) {
    if (scalp) pulse.gap_mm = gapToSkin_mm(*pulse.mri_T_coil(), *scalp);
    if (pulse.gap_mm && before.live) pulse.gap_stereo_mm = *pulse.gap_mm - before.live->above_skin_mm;
    judge(pulse, before);
  } else {
    pulse.reason = before.loss.empty() ? after.loss : before.loss;
  }
}

}  // namespace

PosedFrame posedFrame(const NavigationState& state) {
  PosedFrame posed{state.frame, state.captured,  state.taken,    {}, {}, state.chosen, state.tolerance,
                   {},          state.coil_name, state.gap.live, {}};
  if (state.camera_T_mri) posed.camera_T_mri = *state.camera_T_mri;
  if (state.camera_T_coil) posed.camera_T_coil = *state.camera_T_coil;
  if (!state.camera_T_mri || !state.camera_T_coil) posed.loss = titleOf(lossInWords(state));
  if (!state.second) return posed;
  PosedFrame second = posed;
  second.coil = state.second->name;
  second.chosen = state.second->chosen;
  second.live.reset();
  second.camera_T_coil.reset();
  if (state.second->camera_T_coil) second.camera_T_coil = *state.second->camera_T_coil;
  second.loss.clear();
  if (!state.camera_T_mri)
    second.loss = posed.loss;
  else if (!state.second->camera_T_coil)
    second.loss = titleOf(secondCoilLossInWords(state));
  posed.second = std::make_shared<const PosedFrame>(std::move(second));
  return posed;
}

std::optional<PosedFrame> ofCoil(const std::optional<PosedFrame>& frame, const std::string& coil) {
  if (!frame || frame->coil == coil) return frame;
  if (coil.empty()) return frame->second ? std::nullopt : frame;
  if (frame->second && frame->second->coil == coil) return *frame->second;
  return std::nullopt;
}

casefile::Pulse pulseBetween(const PulseTrigger& trigger, const std::optional<PosedFrame>& earlier,
                             const std::optional<PosedFrame>& later, const registration::ScalpField* scalp) {
  const auto before = ofCoil(earlier, trigger.coil), after = ofCoil(later, trigger.coil);
  casefile::Pulse pulse;
  const double between_s = earlier && later ? later->taken - earlier->taken : 0.0;
  const double fraction =
      between_s > 0 ? std::clamp((trigger.at - earlier->taken) / between_s, 0.0, 1.0) : 0.0;
  pulse.t_s = sourceTime_s(trigger.at, earlier, later, fraction);
  describe(trigger, before ? &*before : after ? &*after : nullptr, pulse);
  pulse.reason = otherCoil(trigger, earlier, before);
  if (pulse.reason.empty()) pulse.reason = otherCoil(trigger, later, after);
  if (pulse.reason.empty()) pulse.reason = missingFrames(before, after);
  if (pulse.reason.empty()) {
    pulse.fraction = fraction;
    place(*before, *after, scalp, pulse);
  }
  markPause(pulse);
  return pulse;
}

}  // namespace facenav::session
