#include "facenav/plan/expert_pose.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/core/utc_time.h"
#include "facenav/geometry/median_pose.h"
#include "facenav/geometry/rotation.h"
#include "facenav/plan/plan_edits.h"
#include "facenav/plan/pose_target.h"

namespace facenav::steps {
namespace {

using ExpertPulses = std::vector<const casefile::Pulse*>;

std::string targetOf(const casefile::Pulse& pulse) { return pulse.target ? pulse.target->name : ""; }

bool hasPose(const casefile::ReviewedPulse& reviewed) {
  return !reviewed.is_excluded && reviewed.pulse.mri_T_coil().has_value();
}

ExpertPulses onePulse(const casefile::KeptSession& session, int number) {
  for (const auto& reviewed : session.pulses.pulses) {
    if (reviewed.pulse.number != number) continue;
    if (reviewed.is_excluded)
      throw Error("pulse " + std::to_string(number) + " is excluded (" + reviewed.note + ")", session.name);
    if (!hasPose(reviewed))
      throw Error("pulse " + std::to_string(number) + " has no pose: " + reviewed.pulse.reason, session.name,
                  "choose another pulse");
    return {&reviewed.pulse};
  }
  throw Error("there is no pulse " + std::to_string(number), session.name,
              formatted("it has %zu pulses", session.pulses.pulses.size()));
}

/// Name of the target with the most pulses on target; nothing if no pulse was.
std::optional<std::string> mostHit(const casefile::KeptSession& session) {
  std::map<std::string, int> hits;
  for (const auto& reviewed : session.pulses.pulses)
    if (hasPose(reviewed) && reviewed.pulse.status == casefile::PulseStatus::on_target)
      ++hits[targetOf(reviewed.pulse)];
  const auto most = std::max_element(hits.begin(), hits.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == hits.end() ? std::nullopt : std::optional(most->first);
}

ExpertPulses pulsesOnTarget(const casefile::KeptSession& session, const std::string& target) {
  ExpertPulses pulses;
  for (const auto& reviewed : session.pulses.pulses)
    if (hasPose(reviewed) && reviewed.pulse.status == casefile::PulseStatus::on_target &&
        targetOf(reviewed.pulse) == target)
      pulses.push_back(&reviewed.pulse);
  return pulses;
}

/// Collects the pulses of a session without a target: all with a pose, since none can be on target.
ExpertPulses pulsesWithoutTarget(const casefile::KeptSession& session) {
  ExpertPulses pulses;
  for (const auto& reviewed : session.pulses.pulses)
    if (hasPose(reviewed) && !reviewed.pulse.target) pulses.push_back(&reviewed.pulse);
  return pulses;
}

ExpertPulses pulsesFor(const casefile::KeptSession& session, const ExpertRequest& request) {
  if (request.pulse) return onePulse(session, *request.pulse);
  const auto target = request.from_target.empty() ? mostHit(session) : std::optional(request.from_target);
  auto pulses = target ? pulsesOnTarget(session, *target) : pulsesWithoutTarget(session);
  if (pulses.empty())
    throw Error("the session has no pulse on target" + (target ? " '" + *target + "'" : std::string()),
                session.name, "choose one pulse with --pulse N, or another session");
  return pulses;
}

std::string oneCoilOf(const ExpertPulses& pulses, const casefile::KeptSession& session) {
  const std::string& coil = pulses.front()->coil;
  for (const auto* pulse : pulses)
    if (pulse->coil != coil)
      throw Error("the pulses are of two coils, '" + coil + "' and '" + pulse->coil + "'", session.name,
                  "choose one pulse with --pulse N");
  if (!coil.empty()) return coil;
  for (auto event = session.events.rbegin(); event != session.events.rend(); ++event)
    if (event->event == "coil") return event->detail;  // older sessions: pulses do not name their coil
  return {};
}

struct MedianCoil {
  RigidTransform<Mri, Coil> mri_T_coil;
  double spread_mm = 0, spread_deg = 0;
};

MedianCoil medianOf(const ExpertPulses& pulses) {
  std::vector<Eigen::Vector3d> centres;
  std::vector<Eigen::Matrix3d> rotations;
  for (const auto* pulse : pulses) {
    const auto pose = *pulse->mri_T_coil();
    centres.push_back(pose.translation_mm());
    rotations.push_back(pose.rotation());
  }
  const Eigen::Vector3d centre = medianPoint(centres);
  const Eigen::Matrix3d rotation = medianRotation(rotations);
  std::vector<double> apart_mm, apart_deg;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    apart_mm.push_back((centres[i] - centre).norm());
    apart_deg.push_back(rotationAngle(rotation.transpose() * rotations[i]) * kDegPerRad);
  }
  return {{Eigen::Quaterniond(rotation), centre}, upperMedian(apart_mm), upperMedian(apart_deg)};
}

void requireOnePose(const MedianCoil& median, const casefile::KeptSession& session) {
  const auto& rules = settingsOf<ExpertRules>();
  if (median.spread_mm <= rules.most_spread_mm && median.spread_deg <= rules.most_spread_deg) return;
  throw Error(formatted("the pulses lie %.1f mm and %.1f deg round their median: they are not one pose",
                        median.spread_mm, median.spread_deg),
              session.name, "choose one pulse with --pulse N, or exclude those that slipped");
}

/// Gap to the skin measured at the pulses.
double gapOf(const ExpertPulses& pulses) {
  std::vector<double> gaps;
  for (const auto* pulse : pulses)
    if (pulse->gap_mm) gaps.push_back(*pulse->gap_mm);
  return gaps.empty() ? 0.0 : std::max(0.0, upperMedian(gaps));
}

Point<Mri> alongAxis(const RigidTransform<Mri, Coil>& mri_T_coil, double mm) {
  return mri_T_coil * Point<Coil>(0, 0, mm);
}

/// Point where the axis meets the brain; else at the depth of the session's target, or the usual one.
Point<Mri> cortexOn(const casefile::CaseStore& store, const RigidTransform<Mri, Coil>& mri_T_coil,
                    const casefile::Pulse& pulse) {
  std::optional<double> depth_mm;
  if (pulse.target) depth_mm = (mri_T_coil.inverse() * pulse.target->cortex_point).mm.z();
  return cortexOnAxis(store, mri_T_coil, depth_mm);
}

double predictedErrorOf(const ExpertPulses& pulses) {
  double worst_mm = 0;
  for (const auto* pulse : pulses) worst_mm = std::max(worst_mm, pulse->predicted_error_mm.value_or(0));
  return worst_mm;
}

}  // namespace

guidance::Target expertPose(const casefile::CaseStore& store, const ExpertRequest& request) {
  const auto session = casefile::readSession(casefile::findSession(store.folder(), request.session));
  const auto pulses = pulsesFor(session, request);
  const std::string coil = oneCoilOf(pulses, session);
  const MedianCoil median = medianOf(pulses);
  requireOnePose(median, session);
  guidance::Target target;
  const std::string old = targetOf(*pulses.front());
  target.name = !request.name.empty() ? request.name : old.empty() ? "expert" : "expert " + old;
  target.mri_T_target = median.mri_T_coil.reframe<Mri, frames::Target>();
  target.scalp_point = alongAxis(median.mri_T_coil, gapOf(pulses));
  target.cortex_point = cortexOn(store, median.mri_T_coil, *pulses.front());
  if (const auto& planned = pulses.front()->target) target.dose = planned->dose;
  target.expert = guidance::ExpertPose{session.name,      int(pulses.size()),       median.spread_mm,
                                       median.spread_deg, predictedErrorOf(pulses), coil};
  target.changes = {{isoUtc(std::chrono::system_clock::now()), request.by, inWords(*target.expert)}};
  return target;
}

guidance::Target storeExpertPose(const casefile::CaseStore& store, const ExpertRequest& request) {
  const auto target = expertPose(store, request);
  const auto plan = store.targets();
  if (const auto* old = find(plan, target.name); old && old->is_locked)
    throw Error("the target '" + old->name + "' is locked", store.folder().string(),
                "unlock it first, or give another --name");
  store.setTargets(with(plan, target.name, target));
  return target;
}

std::optional<std::string> outsideCaution(const casefile::CaseStore& store, const ExpertRequest& request) {
  const auto session = casefile::readSession(casefile::findSession(store.folder(), request.session));
  for (const auto* pulse : pulsesFor(session, request)) {
    if (pulse->status != casefile::PulseStatus::outside) continue;
    std::string words = formatted("pulse %d lay outside the tolerance", pulse->number);
    if (pulse->offset)
      words +=
          formatted(": %.1f mm, %.0f deg from '%s'", pulse->offset->distance_mm,
                    std::hypot(pulse->offset->tilt_deg, pulse->offset->twist_deg), targetOf(*pulse).c_str());
    return words;
  }
  return std::nullopt;
}

std::optional<std::string> otherCoilCaution(const guidance::Target& target, const std::string& coil) {
  if (!target.expert || target.expert->coil.empty() || target.expert->coil == coil) return std::nullopt;
  return "the expert held the coil '" + target.expert->coil + "' there, this is '" + coil + "'";
}

std::string inWords(const guidance::ExpertPose& expert) {
  std::string words = expert.pulses == 1 ? "one pulse" : formatted("median of %d pulses", expert.pulses);
  words += " of session " + expert.session;
  if (expert.pulses > 1) words += formatted(", spread %.1f mm %.1f deg", expert.spread_mm, expert.spread_deg);
  return expert.coil.empty() ? words : words + ", coil " + expert.coil;
}

}  // namespace facenav::steps
