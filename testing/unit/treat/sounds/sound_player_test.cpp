// The output is a file, by ALSA's plugin.

#include "facenav/sounds/sound_player.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <thread>

#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav::sounds {
namespace {

using namespace std::chrono_literals;

std::string keepingIn(const std::filesystem::path& file) {
  return "file:FILE='" + file.string() + "',FORMAT=raw";
}

std::vector<std::int16_t> heardIn(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  const std::string bytes = readWholeFile(file);
  std::vector<std::int16_t> samples(bytes.size() / 2);
  if (!samples.empty()) std::memcpy(samples.data(), bytes.data(), 2 * samples.size());
  return samples;
}

bool holds(const std::vector<std::int16_t>& heard, const std::vector<std::int16_t>& tone) {
  return std::search(heard.begin(), heard.end(), tone.begin(), tone.end()) != heard.end();
}

template <class Condition>
bool waitFor(Condition condition) {
  for (int i = 0; i < 500 && !condition(); ++i) std::this_thread::sleep_for(10ms);
  return condition();
}

TEST(SoundPlayer, WhatWasAskedForIsHeardSampleBySample) {
  const testing::TemporaryFolder folder;
  const auto file = folder.path() / "heard";
  SoundPlayer player(keepingIn(file));
  player.setVolume(0.4);
  player.play(Tone::lost);
  EXPECT_TRUE(waitFor([&] { return holds(heardIn(file), samplesOf(Tone::lost, 0.4)); }));
  player.play(Tone::on_target);
  EXPECT_TRUE(waitFor([&] { return holds(heardIn(file), samplesOf(Tone::on_target, 0.4)); }));
  EXPECT_EQ(player.failure(), "");
}

TEST(SoundPlayer, MutedIsSilent) {
  const testing::TemporaryFolder folder;
  const auto file = folder.path() / "heard";
  SoundPlayer player(keepingIn(file));
  player.setMuted(true);
  player.play(Tone::on_target);
  ASSERT_TRUE(waitFor([&] { return heardIn(file).size() > kSamplesPerSecond / 3; }));
  const auto heard = heardIn(file);
  EXPECT_TRUE(std::all_of(heard.begin(), heard.end(), [](auto sample) { return sample == 0; }));
}

TEST(SoundPlayer, AMachineWithoutSoundIsSilentAndSaysSo) {
  SoundPlayer player("facenav-no-such-output");
  for (int i = 0; i < 3; ++i) player.play(Tone::pulse);
  ASSERT_TRUE(waitFor([&] { return !player.failure().empty(); }));
  EXPECT_THAT(player.failure(), ::testing::HasSubstr("no sound"));
  player.play(Tone::pulse);  // harmless
}

TEST(SoundPlayer, NothingStartsWithoutATone) {
  const testing::TemporaryFolder folder;
  const auto file = folder.path() / "heard";
  { SoundPlayer player(keepingIn(file)); }
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace facenav::sounds
