// The coil's click by its sound: the detector on synthetic sound, the clock of a sound card, and both inputs.

#include <gmock/gmock.h>
#include <stdlib.h>

#include <fstream>
#include <limits>

#include "click_detector.h"
#include "facenav/core/error.h"
#include "sound_input.h"
#include "support/made_clicks.h"
#include "support/pulse_source_contract.h"
#include "support/refusal.h"
#include "support/test_data.h"

#ifdef FACENAV_HAS_SNDFILE
#include <sndfile.h>
#endif

namespace facenav::links {
namespace {

using facenav::testing::refusalOf;
using ::testing::HasSubstr;
using testing::MadeClicks;

testing::ClickScore heardIn(const MadeClicks& made) {
  const auto sound = testing::madeSound(made);
  ClickDetector detector(made.samples_per_s, 0.012);
  std::vector<double> told_s;
  constexpr std::size_t kBlock = 241;  // as a card delivers it
  for (std::size_t at = 0; at < sound.samples.size(); at += kBlock)
    for (const auto sample : detector.hear(&sound.samples[at], std::min(kBlock, sound.samples.size() - at)))
      told_s.push_back(double(sample) / made.samples_per_s);
  return testing::scoreOf(sound.clicks_s, told_s);
}

/// Seeds for the tests; the rules were fitted on seeds 1 to 8.
constexpr unsigned kFirst = 201, kLast = 206;

TEST(Clicks, OfTrainsAreHeardOnceAndToTheMillisecond) {
  for (const double rate : {48000.0, 44100.0}) {
    MadeClicks made;
    made.samples_per_s = rate;
    made.pulses = 100;
    made.over_speech_db = std::numeric_limits<double>::infinity();
    for (made.seed = kFirst; made.seed <= kLast; ++made.seed) {
      const auto score = heardIn(made);
      EXPECT_EQ(score.missed, 0) << rate << " " << made.seed;
      EXPECT_EQ(score.doubled, 0) << "an echo counted";
      EXPECT_EQ(score.wrong, 0) << rate << " " << made.seed;
      EXPECT_LT(score.worst_ms, 0.5);
    }
  }
}

TEST(Clicks, AreHeardThroughSpeechAndHum) {
  int missed = 0, wrong = 0, pulses = 0;
  for (unsigned seed = kFirst; seed <= kLast; ++seed) {
    MadeClicks made;
    made.over_speech_db = 30;
    made.hum = 0.1;
    made.seed = seed;
    const auto score = heardIn(made);
    missed += score.missed, wrong += score.wrong, pulses += made.pulses;
    EXPECT_EQ(score.doubled, 0);
    EXPECT_LT(score.worst_ms, 2.0);
  }
  EXPECT_LE(missed, pulses / 100);
  EXPECT_LE(wrong, pulses / 100);
}

TEST(Clicks, OfThetaBurstsAreTwentyMillisecondsApart) {
  MadeClicks made;
  made.pulses = 90;
  made.in_train = 3;
  made.step_s = 0.02;
  made.pause_s = 0.14;
  made.over_speech_db = std::numeric_limits<double>::infinity();
  int missed = 0;
  for (made.seed = kFirst; made.seed <= kLast; ++made.seed) missed += heardIn(made).missed;
  EXPECT_LE(missed, 6 * 90 / 100);
}

TEST(Clicks, SpeechAloneIsNoPulse) {
  int wrong = 0;
  for (unsigned seed = kFirst; seed <= kLast; ++seed) {
    MadeClicks made;
    made.pulses = 0;
    made.pause_s = 0;
    made.over_speech_db = 10;  // loud
    made.seed = seed;
    wrong += heardIn(made).wrong;
  }
  EXPECT_LE(wrong, 1) << "in " << 2 * (kLast - kFirst + 1) << " s";
}

TEST(SampleClock, ADriversLateCountsDoNotDelayAPulse) {
  constexpr double kRate = 48000, kTrue = kRate * (1 + 30e-6);  // a card that runs fast
  SampleClock clock(kRate);
  std::mt19937 random(3);
  std::exponential_distribution<double> late_s(1 / 0.004);
  double worst_ms = 0;
  for (double t_s = 100; t_s < 160; t_s += 0.005) {
    clock.note(std::int64_t((t_s - 100) * kTrue), {t_s + late_s(random)});
    const auto sample = std::int64_t((t_s - 0.02 - 100) * kTrue);
    if (t_s > 100.5) worst_ms = std::max(worst_ms, 1e3 * std::abs(clock.timeOf(sample).s - (t_s - 0.02)));
  }
  EXPECT_LT(worst_ms, 1.0);
}

TEST(SoundSource, SaysWhatIsMissing) {
  EXPECT_THAT(refusalOf([] { openPulseSource("sound:/nonexistent/train.wav"); }),
              HasSubstr("there is no such sound file"));
#ifdef FACENAV_HAS_ALSA
  const auto source = openPulseSource("sound:hw:31,7");
  const auto words = refusalOf([&] { source->start({}); });
  EXPECT_THAT(words, HasSubstr("hw:31,7"));
  EXPECT_THAT(words, HasSubstr("there is no such sound input"));
#endif
}

#ifdef FACENAV_HAS_SNDFILE
TEST(SoundSource, ARecordedTrainIsHeardAsItIsPlayed) {
  MadeClicks made;
  made.pulses = 12;
  made.pause_s = 0.1;
  made.over_speech_db = 30;
  made.seed = 301;
  const auto sound = testing::madeSound(made);
  const testing::TemporaryFolder folder;
  const auto path = folder.path() / "train.wav";
  SF_INFO info{};
  info.samplerate = int(made.samples_per_s);
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  ASSERT_TRUE(file);
  sf_writef_float(file, sound.samples.data(), sf_count_t(sound.samples.size()));
  sf_close(file);
  const auto source = openPulseSource("sound:" + path.string());
  testing::HeardPulses heard;
  const Timestamp begin = Timestamp::now();
  source->start(heard.listener());
  for (int i = 0; i < 6000 && heard.problems().empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  source->stop();
  const auto pulses = heard.triggers();
  ASSERT_EQ(pulses.size(), 12u);
  EXPECT_LT(pulses[0].dead_time_s, 0.02);
  for (std::size_t i = 0; i < pulses.size(); ++i) {
    EXPECT_NEAR(pulses[i].at - pulses[0].at, sound.clicks_s[i] - sound.clicks_s[0], 0.002) << i;
    EXPECT_GE(pulses[i].at - begin, sound.clicks_s[i] - 0.001);
  }
  ASSERT_FALSE(heard.problems().empty());
  EXPECT_THAT(heard.problems().back(), HasSubstr("the sound is over"));
  const auto damaged = folder.path() / "damaged.wav";
  std::ofstream(damaged) << "RIFF, but no more";
  EXPECT_THAT(refusalOf([&] { openPulseSource("sound:" + damaged.string())->start({}); }),
              HasSubstr("cannot be read"));
}
#endif

#ifdef FACENAV_HAS_ALSA
/// ALSA's own plug-ins replace a card: the "captured" sound comes from a file.
TEST(SoundSource, ADeviceOfAlsaIsHeard) {
  MadeClicks made;
  made.pulses = 12;
  made.over_speech_db = 30;
  made.seed = 302;
  const auto sound = testing::madeSound(made);
  const testing::TemporaryFolder folder;
  const auto raw = folder.path() / "sound.raw", rules = folder.path() / "asound.conf";
  std::ofstream samples(raw, std::ios::binary);
  for (const float s : sound.samples) {
    const auto value = std::int16_t(std::lround(32767 * s));
    samples.write(reinterpret_cast<const char*>(&value), sizeof value);
  }
  samples.close();
  std::ofstream(rules) << "pcm.made { type file\n slave.pcm { type null }\n file /dev/null\n infile \""
                       << raw.string() << "\"\n format raw }\n";
  ::setenv("ALSA_CONFIG_PATH", rules.c_str(), 1);
  const auto source = openPulseSource("sound:made");
  testing::HeardPulses heard;
  source->start(heard.listener());
  heard.waitFor(12);
  source->stop();
  ::unsetenv("ALSA_CONFIG_PATH");
  EXPECT_GE(heard.triggers().size(), 12u);
}
#endif

}  // namespace
}  // namespace facenav::links
