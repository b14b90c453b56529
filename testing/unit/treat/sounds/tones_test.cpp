#include "facenav/sounds/tones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace facenav::sounds {
namespace {

constexpr Tone kAll[] = {Tone::lost, Tone::approaching, Tone::on_target, Tone::pulse};

/// Pitch of the part from `from_s` to `to_s`, by its zero crossings.
double pitch_hz(const std::vector<std::int16_t>& samples, double from_s, double to_s) {
  int crossings = 0;
  const auto begin = std::size_t(from_s * kSamplesPerSecond), end = std::size_t(to_s * kSamplesPerSecond);
  for (std::size_t i = begin + 1; i < end; ++i) crossings += (samples[i - 1] < 0) != (samples[i] < 0);
  return crossings / 2.0 / (to_s - from_s);
}

int loudest(const std::vector<std::int16_t>& samples) {
  int most = 0;
  for (const auto sample : samples) most = std::max(most, std::abs(int(sample)));
  return most;
}

TEST(Tones, PitchAndDirectionTellThemApart) {
  const auto lost = samplesOf(Tone::lost, 1), on_target = samplesOf(Tone::on_target, 1);
  EXPECT_NEAR(pitch_hz(lost, 0.01, 0.17), 440, 8);
  EXPECT_NEAR(pitch_hz(lost, 0.19, 0.42), 220, 8);
  EXPECT_NEAR(pitch_hz(on_target, 0.01, 0.08), 880, 16);
  EXPECT_NEAR(pitch_hz(on_target, 0.1, 0.24), 1320, 16);
  EXPECT_NEAR(pitch_hz(samplesOf(Tone::approaching, 1), 0.01, 0.08), 660, 16);
  EXPECT_NEAR(double(samplesOf(Tone::pulse, 1).size()) / kSamplesPerSecond, 0.02, 1e-3);
}

TEST(Tones, VolumeIsProportionalAndNeverMoreThanHalfOfFullScale) {
  for (const Tone tone : kAll) {
    EXPECT_NEAR(loudest(samplesOf(tone, 1)), 16384, 350);
    EXPECT_NEAR(loudest(samplesOf(tone, 0.25)), 4096, 90);
    EXPECT_EQ(loudest(samplesOf(tone, 0)), 0);
    EXPECT_EQ(samplesOf(tone, 7), samplesOf(tone, 1));
    EXPECT_EQ(samplesOf(tone, -1), samplesOf(tone, 0));
  }
}

TEST(Tones, NoToneClicks) {
  for (const Tone tone : kAll) {
    const auto samples = samplesOf(tone, 1);
    EXPECT_EQ(samples.front(), 0);
    EXPECT_EQ(samples.back(), 0);
    EXPECT_GE(samples.size(), std::size_t(kSamplesPerSecond / 100));
  }
}

}  // namespace
}  // namespace facenav::sounds
