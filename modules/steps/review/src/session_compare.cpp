#include "facenav/review/session_compare.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "facenav/guidance/guidance.h"

namespace facenav::steps {
namespace {

bool counts(const casefile::ReviewedPulse& reviewed, const std::string& target) {
  return !reviewed.is_excluded && reviewed.pulse.target && reviewed.pulse.target->name == target &&
         reviewed.pulse.mri_T_coil();
}

/// Names of the targets in the order of their first pulse with a pose.
std::vector<std::string> targetNamesOf(const std::vector<casefile::ReviewedPulse>& pulses) {
  std::vector<std::string> names;
  for (const auto& reviewed : pulses) {
    if (!reviewed.pulse.target || !counts(reviewed, reviewed.pulse.target->name)) continue;
    const std::string& name = reviewed.pulse.target->name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// Mean rotation: the eigenvector of the largest eigenvalue of the sum of q q^T; q and -q are equivalent.
Eigen::Quaterniond meanOf(const std::vector<Eigen::Quaterniond>& rotations) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const auto& q : rotations) sum += q.coeffs() * q.coeffs().transpose();
  Eigen::Quaterniond mean;
  mean.coeffs() = principalAxes(sum).vectors.col(3);
  return mean.normalized();
}

const guidance::Target& firstTarget(const std::vector<casefile::ReviewedPulse>& pulses,
                                    const std::string& name) {
  const auto found = std::find_if(pulses.begin(), pulses.end(),
                                  [&](const auto& reviewed) { return counts(reviewed, name); });
  return *found->pulse.target;
}

std::optional<double> medianMep_uv(const std::vector<casefile::ReviewedPulse>& pulses,
                                   const std::string& target) {
  std::vector<double> meps_uv;
  for (const auto& reviewed : pulses)
    if (counts(reviewed, target) && reviewed.pulse.mep_uv) meps_uv.push_back(*reviewed.pulse.mep_uv);
  return meps_uv.empty() ? std::nullopt : std::optional(median(meps_uv));
}

double angle_deg(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return kDegPerRad * Eigen::AngleAxisd(a.transpose() * b).angle();
}

TargetReturn returnTo(const std::string& name, const std::vector<casefile::ReviewedPulse>& first,
                      const std::vector<casefile::ReviewedPulse>& second) {
  TargetReturn back;
  back.target = name;
  back.first = *meanCoil(first, name);
  back.second = *meanCoil(second, name);
  const auto &before = back.first.mri_T_coil, &after = back.second.mri_T_coil;
  guidance::Target as_target;
  // The first session's coil pose is the target of the second one.
  as_target.mri_T_target = before.reframe<Mri, frames::Target>();
  const auto values = guidance::evaluate(as_target, after);
  back.distance_mm = values.distance_mm;
  back.tilt_deg = kDegPerRad * values.tilt_rad;
  back.twist_deg = kDegPerRad * values.twist_rad;
  back.angle_deg = angle_deg(before.rotation(), after.rotation());
  const auto &old_target = firstTarget(first, name), &new_target = firstTarget(second, name);
  back.target_moved_mm =
      (new_target.mri_T_target.translation_mm() - old_target.mri_T_target.translation_mm()).norm();
  back.target_turned_deg = angle_deg(old_target.mri_T_target.rotation(), new_target.mri_T_target.rotation());
  back.mep_first_uv = medianMep_uv(first, name);
  back.mep_second_uv = medianMep_uv(second, name);
  return back;
}

}  // namespace

std::optional<MeanCoil> meanCoil(const std::vector<casefile::ReviewedPulse>& pulses,
                                 const std::string& target) {
  std::vector<Eigen::Quaterniond> rotations;
  std::vector<Eigen::Vector3d> centres_mm;
  Eigen::Vector3d sum_mm = Eigen::Vector3d::Zero();
  for (const auto& reviewed : pulses) {
    if (!counts(reviewed, target)) continue;
    const auto mri_T_coil = *reviewed.pulse.mri_T_coil();
    rotations.push_back(mri_T_coil.quaternion());
    centres_mm.push_back(mri_T_coil.translation_mm());
    sum_mm += centres_mm.back();
  }
  if (rotations.empty()) return std::nullopt;
  const double count = double(rotations.size());
  const Eigen::Quaterniond rotation = meanOf(rotations);
  MeanCoil mean{{rotation, sum_mm / count}, int(rotations.size())};
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    mean.spread_mm += (centres_mm[i] - sum_mm / count).squaredNorm() / count;
    mean.spread_deg += std::pow(kDegPerRad * rotations[i].angularDistance(rotation), 2) / count;
  }
  mean.spread_mm = std::sqrt(mean.spread_mm);
  mean.spread_deg = std::sqrt(mean.spread_deg);
  return mean;
}

SessionComparison compareSessions(const std::vector<casefile::ReviewedPulse>& first,
                                  const std::vector<casefile::ReviewedPulse>& second) {
  SessionComparison comparison;
  const auto first_names = targetNamesOf(first), second_names = targetNamesOf(second);
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& name : first_names) {
    if (has(second_names, name))
      comparison.targets.push_back(returnTo(name, first, second));
    else
      comparison.only_first.push_back(name);
  }
  for (const auto& name : second_names)
    if (!has(first_names, name)) comparison.only_second.push_back(name);
  return comparison;
}

}  // namespace facenav::steps
