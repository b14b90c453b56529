#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <random>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"
#include "facenav/review/mep_import.h"
#include "support/made_xdf.h"
#include "support/refusal.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_pulse.h"
#include "xdf/xdf_clock.h"

namespace facenav::steps {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MadeXdf;

constexpr int kPulses = 12;
constexpr double kRate_hz = 2000, kUtc_s = 1.79e9, kStart_s = 5000;  // of the recorder's clock
constexpr double kMarkersBehind_s = 700, kEmgBehind_s = -250;        // the streams' clocks

/// Time of a pulse on the recorder's clock: at uneven intervals.
double pulse_s(int i) { return kStart_s + 3 + 4.0 * i + 0.9 * ((i * 7) % 5) / 5.0; }
double mep_uv(int i) { return 100.0 + 50.0 * i; }

/// EMG of one channel: rest, an artefact of 20 mV until 5 ms, and a wave from 22 to 37 ms.
double emg_uv(double t_s) {
  for (int i = 0; i < kPulses; ++i) {
    const double after_ms = 1000 * (t_s - pulse_s(i));
    if (after_ms >= 0 && after_ms < 5) return 20000;
    if (after_ms >= 22 && after_ms < 37)
      return 0.5 * mep_uv(i) * std::sin(2 * EIGEN_PI * (after_ms - 22) / 15);
  }
  return 0;
}

std::string ownMarker(int i) {
  const std::chrono::duration<double> utc_s(kUtc_s + pulse_s(i));
  return R"({"pulse":true,"source":"pedal","utc":")" +
         isoUtc(std::chrono::system_clock::time_point(
             std::chrono::duration_cast<std::chrono::system_clock::duration>(utc_s))) +
         "\"}";
}

struct Recording {
  std::string unit = "microvolts", markers_name = "Stimulator";
  bool is_own = false, has_other_markers = false;
};

/// Chunks of 50 ms as LabRecorder writes them, the stamp of the first sample only, with 2 ms of jitter.
void addEmg(MadeXdf& xdf, double factor) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter_s(-0.002, 0.002);
  for (int begin = 0; begin < int(60 * kRate_hz); begin += 100) {
    xdf.beginSamples(7);
    for (int i = begin; i < begin + 100; ++i) {
      const double t_s = kStart_s + i / kRate_hz;
      const auto stamp = i == begin ? std::optional(t_s - kEmgBehind_s + jitter_s(random)) : std::nullopt;
      xdf.sample<float>(stamp, {float(factor * emg_uv(t_s)), 1.f});
    }
    xdf.endSamples();
  }
}

std::string recorded(const Recording& wanted = {}) {
  MadeXdf xdf;
  xdf.stream(3, wanted.is_own ? "FaceNav" : wanted.markers_name, "Markers", 1, 0, "string");
  xdf.stream(7, "Amplifier", "EMG", 2, kRate_hz, "float32",
             "<channels>" + MadeXdf::channel("FDI", wanted.unit, "EMG") +
                 MadeXdf::channel("trigger", "", "TRIG") + "</channels>");
  for (double at_s = kStart_s; at_s < kStart_s + 60; at_s += 5) {
    xdf.offset(3, at_s - kMarkersBehind_s, kMarkersBehind_s);
    xdf.offset(7, at_s - kEmgBehind_s, kEmgBehind_s);
  }
  for (int i = 0; i < kPulses; ++i) {
    xdf.text(3, pulse_s(i) - kMarkersBehind_s, wanted.is_own ? ownMarker(i) : "T");
    if (wanted.has_other_markers) xdf.text(3, pulse_s(i) + 1 - kMarkersBehind_s, "rest");
  }
  addEmg(xdf, wanted.unit == "mV" ? 1e-3 : 1);
  return xdf.bytes;
}

/// The session's pulses; its clock began 4990 s after the recorder's.
std::vector<casefile::ReviewedPulse> sessionPulses() {
  std::vector<casefile::ReviewedPulse> pulses;
  for (int i = 0; i < kPulses; ++i) {
    casefile::ReviewedPulse reviewed{casefile::madePulse(i + 1), false, {}};
    reviewed.pulse.t_s = pulse_s(i) - 4990;
    const std::chrono::duration<double> utc_s(kUtc_s + pulse_s(i));
    reviewed.pulse.utc = isoUtc(std::chrono::system_clock::time_point(
        std::chrono::duration_cast<std::chrono::system_clock::duration>(utc_s)));
    pulses.push_back(reviewed);
  }
  return pulses;
}

class MepXdf : public ::testing::Test {
 protected:
  MepFile read(const std::string& bytes, const XdfChoice& choice = {}) {
    std::ofstream(path_, std::ios::binary) << bytes;
    return readMepFile(path_, choice);
  }
  std::string refusal(const std::string& bytes, const XdfChoice& choice = {}) {
    return testing::refusalOf([&] { read(bytes, choice); });
  }
  const testing::TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "session.xdf";
};

void expectMeps(const MepMatch& match) {
  ASSERT_EQ(match.edits.size(), std::size_t(kPulses));
  for (const auto& edit : match.edits)
    EXPECT_NEAR(*edit.mep_uv, mep_uv(edit.number - 1), 0.02 * *edit.mep_uv);
}

TEST_F(MepXdf, MeasuresThePeakToPeakAfterEachMarkerAcrossThreeClocks) {
  const auto file = read(recorded());
  EXPECT_FALSE(file.is_own_clock);
  ASSERT_EQ(file.rows.size(), std::size_t(kPulses));
  EXPECT_NEAR(file.rows[2].t_s, pulse_s(2), 1e-6) << "on the recorder's clock";
  const auto match = matchMeps(file, sessionPulses(), std::nullopt, MepImportLimits());
  EXPECT_TRUE(match.is_offset_found);
  EXPECT_NEAR(match.offset_s, -4990, 0.01);
  expectMeps(match);
  EXPECT_THAT(file.notes.at(0), HasSubstr("channel 1, 15 to 50 ms after the 12 markers of 'Stimulator'"));
}

TEST_F(MepXdf, FaceNavsOwnMarkersNeedNoOffset) {
  const auto file = read(recorded({"mV", "", true}));
  EXPECT_TRUE(file.is_own_clock);
  const auto match = matchMeps(file, sessionPulses(), std::nullopt, MepImportLimits());
  EXPECT_FALSE(match.is_offset_found);
  EXPECT_LT(match.largest_off_ms, 1.1);
  expectMeps(match);
}

TEST_F(MepXdf, WhatIsNotClearIsAskedFor) {
  const auto two = recorded({"microvolts", "Stimulator", false, true});
  EXPECT_THAT(refusal(two), HasSubstr("several markers: 'T' 12 times, 'rest' 12 times"));
  EXPECT_EQ(read(two, {"", "Stimulator:T", ""}).rows.size(), std::size_t(kPulses));
  EXPECT_THAT(refusal(two, {"", "Stimulator:S", ""}), HasSubstr("no such marker"));
  EXPECT_THAT(refusal(two, {"", "Other", ""}), HasSubstr("no such markers: Stimulator"));
  const auto no_unit = recorded({""});
  EXPECT_THAT(refusal(no_unit), HasSubstr("does not say its unit"));
  EXPECT_NEAR(read(no_unit, {"", "", "uV"}).rows.at(0).mep_uv, mep_uv(0), 2);
  EXPECT_TRUE(read(no_unit, {"", "", "V"}).rows.empty()) << "no MEP has volts";
  EXPECT_THAT(refusal(recorded({"furlong"})), HasSubstr("'furlong' is not known"));
  EXPECT_THAT(refusal(recorded(), {"Amplifier:APB", "", ""}), HasSubstr("2 channels: FDI, trigger"));
  EXPECT_THAT(refusal(recorded(), {"Other", "", ""}), HasSubstr("its streams: Amplifier"));
  EXPECT_NEAR(read(recorded(), {"Amplifier:2", "", "uV"}).rows.at(0).mep_uv, 0, 1e-9);
  MadeXdf slow;
  slow.stream(1, "Slow", "EMG", 1, 100, "int16");
  EXPECT_THAT(refusal(slow.bytes), HasSubstr("100 samples a second, too few"));
  EXPECT_EQ(xdfChoiceFrom("EMG:FDI; Pulses:T ;mV").markers, "Pulses:T");
  EXPECT_THROW(xdfChoiceFrom(";;inch"), Error);
}

TEST_F(MepXdf, AFileThatIsCutShortIsUsedUpToThere) {
  const auto whole = recorded();
  const auto file = read(whole.substr(0, whole.size() * 6 / 10));
  EXPECT_GT(file.rows.size(), 4u);
  EXPECT_LT(file.rows.size(), std::size_t(kPulses));
  EXPECT_THAT(file.notes.front(), HasSubstr("cut short at byte"));
  EXPECT_THAT(file.notes.back(), HasSubstr("have no usable EMG"));
}

TEST_F(MepXdf, BrokenAndHugeFilesAreRefusedInOneLine) {
  EXPECT_THAT(refusal("XDF:"), HasSubstr("no streams"));
  EXPECT_THAT(refusal(std::string("XDF:\x08\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x7F\x02", 14)),
              HasSubstr("before any stream"));
  MadeXdf wide;  // claims more samples than it has
  wide.stream(3, "M", "Markers", 1, 0, "string");
  wide.text(3, 10, "T");
  wide.stream(7, "E", "EMG", 1, 1000, "float32",
              "<channels>" + MadeXdf::channel("a", "uV", "EMG") + "</channels>");
  wide.chunk(3, MadeXdf::number(std::uint32_t(7)) + '\10' + MadeXdf::number(std::uint64_t(1) << 60) + '\0');
  EXPECT_THAT(refusal(wide.bytes), HasSubstr("damaged samples"));
  MadeXdf many;
  many.stream(3, "M", "Markers", 100000, 0, "string");
  EXPECT_THAT(refusal(many.bytes), HasSubstr("no streams"));
}

TEST_F(MepXdf, DamagedFilesDoNoHarm) {
  const auto whole = recorded({"microvolts", "Stimulator", true}).substr(0, 70000);
  std::mt19937 random(4848);
  int read_ones = 0;
  for (int n = 0; n < 120; ++n) {
    std::string bytes = whole;
    for (int i = 0; i < 3; ++i) bytes[random() % (n % 2 ? 2500 : bytes.size())] = char(random());
    try {
      read_ones += !read(bytes).rows.empty();
    } catch (const Error&) {
    }
  }
  EXPECT_GT(read_ones, 30);
}

TEST(XdfClock, FollowsDriftAndResetsAndIgnoresASlowAnswer) {
  std::vector<XdfClockOffset> offsets;
  for (int i = 0; i < 20; ++i) offsets.push_back({100.0 + 5 * i, 2 + 1e-5 * 5 * i + (i == 7 ? 0.05 : 0)});
  for (int i = 0; i < 20; ++i) offsets.push_back({10.0 + 5 * i, 900});  // its computer was started anew
  const XdfClock clock(offsets);
  EXPECT_NEAR(clock.offset_s(150), 2 + 1e-5 * 50, 2e-5);
  EXPECT_NEAR(clock.offset_s(20), 900, 1e-6);
  EXPECT_EQ(XdfClock({}).offset_s(5), 0);
}

TEST(XdfTimes, LostSamplesBreakTheLine) {
  XdfSeries series;
  series.values.assign(4000, 0.f);
  for (std::uint64_t i = 0; i < 4000; i += 100)
    series.stamps.push_back({i, 10 + double(i) / 1000 + (i >= 2000 ? 1.5 : 0)});
  const XdfTimes times(series, 1000, XdfClock({}));
  const auto early = times.within(11.0, 11.0199), late = times.within(14.0, 14.0199);
  ASSERT_TRUE(early && late);
  EXPECT_EQ(early->first, 1000u);
  EXPECT_EQ(early->second, 1020u);
  EXPECT_EQ(late->first, 2500u);
  EXPECT_FALSE(times.within(11.99, 12.01)) << "in the gap";
  EXPECT_FALSE(times.within(15.49, 15.51)) << "past the end";
}

}  // namespace
}  // namespace facenav::steps
