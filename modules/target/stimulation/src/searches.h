#pragma once
// The two searches that thresholdAfter() chooses from.

#include "facenav/stimulation/threshold.h"
#include "facenav/stimulation/threshold_rules.h"

namespace facenav::stimulation {

constexpr double kFullOutput_pct = 100;

ThresholdState bayesAfter(const std::vector<ThresholdAnswer>& answers, const ThresholdRules& rules);
ThresholdState fiveOfTenAfter(const std::vector<ThresholdAnswer>& answers, const ThresholdRules& rules);

}  // namespace facenav::stimulation
