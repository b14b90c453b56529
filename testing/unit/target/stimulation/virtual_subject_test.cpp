#include "support/virtual_subject.h"

#include <gtest/gtest.h>

#include <cmath>

#include "facenav/core/robust_statistics.h"

namespace facenav::testing {
namespace {

/// Subject of middle parameters.
VirtualSubject made() {
  VirtualSubject s;
  s.plateau = 4.5, s.half = 4000, s.steepness = 2.6, s.onset_pct = 40;
  s.excitability_spread_pct = 4, s.pathway_spread = 0.1;
  s.noise_v = 8e-6, s.noise_scale_v = 1.5e-6, s.noise_shape = 0.14;
  return s;
}

TEST(VirtualSubject, WithoutAnySpreadTheThresholdIsThatOfTheCurve) {
  VirtualSubject s = made();
  s.excitability_spread_pct = 0, s.pathway_spread = 1e-6, s.noise_scale_v = 1e-15;
  // 42 uV are evoked where plateau / (1 + half / x^steepness) = log10(420).
  const double x = std::pow(s.half / (s.plateau / std::log10(420.0) - 1), 1 / s.steepness);
  EXPECT_NEAR(trueThreshold_pct(s), s.onset_pct + x, 1e-3);
}

TEST(VirtualSubject, TheIntegralAgreesWithDrawnAmplitudes) {
  std::mt19937_64 random(1);
  for (int subject = 0; subject < 5; ++subject) {
    const VirtualSubject s = drawSubject(random);
    const double threshold_pct = trueThreshold_pct(s);
    for (const double intensity_pct : {threshold_pct - 5, threshold_pct, threshold_pct + 5}) {
      int responses = 0;
      const int pulses = 20000;
      for (int i = 0; i < pulses; ++i) responses += drawMep_uv(s, intensity_pct, random) >= 50;
      EXPECT_NEAR(responses / double(pulses), responseProbability(s, intensity_pct), 0.015)
          << intensity_pct << " %";
    }
  }
}

TEST(VirtualSubject, NoStimulusGivesTheNoiseOfTheRecording) {
  std::mt19937_64 random(2);
  std::vector<double> amplitudes_uv;
  for (int i = 0; i < 5001; ++i) amplitudes_uv.push_back(drawMep_uv(made(), 0, random));
  // The median of the extreme value distribution, and the curve's floor of 0.1 uV.
  const double expected_uv = 8 + 1.5 * (std::pow(std::log(2.0), -0.14) - 1) / 0.14 + 0.1;
  EXPECT_NEAR(median(amplitudes_uv), expected_uv, 0.1);
}

TEST(VirtualSubject, ManyDifferAsPeopleDo) {
  std::mt19937_64 random(3);
  std::vector<double> thresholds_pct;
  for (int i = 0; i < 60; ++i) thresholds_pct.push_back(trueThreshold_pct(drawSubject(random)));
  for (const double threshold_pct : thresholds_pct) {
    EXPECT_GT(threshold_pct, 30);
    EXPECT_LT(threshold_pct, 100);
  }
  EXPECT_GT(kSigmaPerMad * medianAbsoluteDeviation(thresholds_pct, median(thresholds_pct)), 3);
}

}  // namespace
}  // namespace facenav::testing
