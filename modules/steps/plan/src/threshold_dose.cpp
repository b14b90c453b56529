#include "facenav/plan/threshold_dose.h"

#include "facenav/casefile/threshold_file.h"
#include "facenav/plan/cortex_field.h"

namespace facenav::steps {

bool operator==(const HotspotThreshold& a, const HotspotThreshold& b) {
  const auto &left = a.hotspot.mri_T_target, &right = b.hotspot.mri_T_target;
  return a.threshold_pct == b.threshold_pct && a.hotspot.name == b.hotspot.name && a.muscle == b.muscle &&
         left.translation_mm() == right.translation_mm() && left.rotation() == right.rotation() &&
         a.hotspot.cortex_point.mm == b.hotspot.cortex_point.mm;
}

std::optional<HotspotThreshold> hotspotThreshold(const std::filesystem::path& case_folder) {
  const auto all = casefile::readThresholds(case_folder);
  for (auto kept = all.rbegin(); kept != all.rend(); ++kept) {
    if (!kept->target) continue;
    const auto state = thresholdAfter(kept->method, kept->plain());
    if (state.isDone() && state.estimate_pct && !state.is_above_output)
      return HotspotThreshold{*kept->target, *state.estimate_pct, kept->muscle};
  }
  return std::nullopt;
}

ThresholdDose thresholdDose(const ReadHead& head, const efield::CoilDipoles& coil,
                            const HotspotThreshold& threshold, double at_target) {
  const auto& hotspot = threshold.hotspot;
  const CoilPose pose = coilPoseOf(hotspot);
  const double there = head.near(pose)->at(coil, pose, Eigen::Matrix3Xd(hotspot.cortex_point.mm)).norm();
  return {hotspot.name, threshold.threshold_pct, there,
          doseByField_pct(there, at_target, threshold.threshold_pct)};
}

}  // namespace facenav::steps
