#include "facenav/review/mep_import.h"

#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/utc_time.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

using ::testing::HasSubstr;

/// Single pulses at intervals of 4 to 7 s, as a person gives them; seeded.
std::vector<casefile::ReviewedPulse> pulses(int count, bool is_even = false) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> pause_s(4, 7);
  std::vector<casefile::ReviewedPulse> given;
  double t_s = 100;
  for (int i = 1; i <= count; ++i) {
    casefile::ReviewedPulse reviewed{casefile::madePulse(i), false, {}};
    reviewed.pulse.t_s = t_s;
    const std::chrono::duration<double> since_epoch(1.79e9 + t_s);
    reviewed.pulse.utc = isoUtc(std::chrono::system_clock::time_point(
        std::chrono::duration_cast<std::chrono::system_clock::duration>(since_epoch)));
    given.push_back(reviewed);
    t_s += is_even ? 5.0 : pause_s(random);
  }
  return given;
}

/// File with one row per pulse, its MEP ten times the pulse's number, on a clock `ahead_s` of the session's.
MepFile fileOf(const std::vector<casefile::ReviewedPulse>& given, double ahead_s, double jitter_s = 0.0) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> jitter(-1, 1);
  MepFile file{"emg.csv", {}, false};
  for (const auto& reviewed : given)
    file.rows.push_back({*reviewed.pulse.t_s + ahead_s + jitter_s * jitter(random),
                         10.0 * reviewed.pulse.number,
                         {},
                         reviewed.pulse.number + 1});
  return file;
}

const MepImportLimits kLimits{};

TEST(MepImport, FindsTheOffsetOfTheClocksAndGivesEachMepToItsPulse) {
  const auto given = pulses(20);
  auto file = fileOf(given, 1234.567, 0.03);
  file.rows.erase(file.rows.begin() + 4);   // one pulse without an MEP
  file.rows.push_back({5000, 70, {}, 99});  // a row without a pulse
  const auto match = matchMeps(file, given, std::nullopt, kLimits);
  EXPECT_TRUE(match.is_offset_found);
  EXPECT_NEAR(match.offset_s, -1234.567, 0.03);
  ASSERT_EQ(match.edits.size(), 19u);
  for (const auto& edit : match.edits) EXPECT_EQ(edit.mep_uv, 10.0 * edit.number);
  ASSERT_EQ(match.left_out.size(), 1u);
  EXPECT_THAT(match.left_out[0], HasSubstr("line 99: no pulse at its time"));
  EXPECT_LT(match.largest_off_ms, 61);
  EXPECT_THAT(mepMatchWords(match, file), HasSubstr("clock offset -1234.5"));
}

TEST(MepImport, EvenIntervalsFitTwoOffsetsNearlyAlikeAndAreRefusedUnlessTheOffsetIsGiven) {
  const auto given = pulses(20, true);
  const auto file = fileOf(given, 30.0);
  try {
    matchMeps(file, given, std::nullopt, kLimits);
    FAIL() << "19 of 20 rows fit one pulse later";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("two clock offsets fit nearly alike (20 and 19 of 20"));
    EXPECT_THAT(error.what(), HasSubstr("--offset"));
  }
  const auto match = matchMeps(file, given, -30.0, kLimits);
  EXPECT_FALSE(match.is_offset_found);
  EXPECT_EQ(match.edits.size(), 20u);
  EXPECT_EQ(match.edits[6].mep_uv, 70.0);
}

TEST(MepImport, TimesOfAnotherSessionAreRefused) {
  const auto given = pulses(20);
  MepFile file{"other.csv", {}, false};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> t_s(0, 4000);
  for (int i = 0; i < 30; ++i) file.rows.push_back({t_s(random), 50, {}, i + 2});
  EXPECT_THROW(matchMeps(file, given, std::nullopt, kLimits), Error);
  EXPECT_THROW(matchMeps(file, {}, std::nullopt, kLimits), Error);
  EXPECT_THROW(matchMeps({"empty.csv", {}, false}, given, 0.0, kLimits), Error);
}

TEST(MepImport, ARowThatCouldBeOfSeveralPulsesAndRowsAtOnePulseAreLeftOut) {
  auto given = pulses(6);
  given[3].pulse.t_s = *given[2].pulse.t_s + 0.1;  // a double pulse
  auto file = fileOf(given, 0.0);
  file.rows.erase(file.rows.begin() + 3);
  file.rows.push_back({*given[5].pulse.t_s + 0.05, 900, {}, 50});  // a second row at pulse 6
  const auto match = matchMeps(file, given, 0.0, kLimits);
  std::vector<int> numbers;
  for (const auto& edit : match.edits) numbers.push_back(edit.number);
  EXPECT_EQ(numbers, (std::vector<int>{1, 2, 5}));
  ASSERT_EQ(match.left_out.size(), 3u);
  EXPECT_THAT(match.left_out[0], HasSubstr("several pulses"));
  EXPECT_THAT(match.left_out[1], HasSubstr("another row is at the same pulse, 6"));
}

TEST(MepImport, ReadsTimesOfDayAndRefusesWhatIsNone) {
  const testing::TemporaryFolder folder;
  const auto given = pulses(5);
  const auto path = folder.path() / "meps.csv";
  {
    std::ofstream csv(path);
    csv << "utc, mep_uv, latency_ms, channel\n";
    for (const auto& reviewed : given)
      csv << reviewed.pulse.utc << ", " << 100 + reviewed.pulse.number << ", 21.5, FDI\n";
    csv << given[0].pulse.utc << ", , ,\n";  // no MEP was measured
  }
  const auto file = readMepFile(path);
  EXPECT_TRUE(file.is_utc);
  ASSERT_EQ(file.rows.size(), 5u);
  const auto match = matchMeps(file, given, std::nullopt, kLimits);
  EXPECT_NEAR(match.offset_s, 0, 1e-3);
  ASSERT_EQ(match.edits.size(), 5u);
  EXPECT_EQ(match.edits[2].mep_uv, 103);
  EXPECT_EQ(match.edits[2].latency_ms, 21.5);
  for (const char* line : {"yesterday,100", "2026-11-23T14:05:09.123Z,-5", "2026-11-23T14:05:09.123Z,big"}) {
    std::ofstream(path) << "utc,mep_uv\n" << line << "\n";
    EXPECT_THROW(readMepFile(path), Error) << line;
  }
  std::ofstream(path) << "time,mep_uv\n1,2\n";
  EXPECT_THROW(readMepFile(path), Error) << "no column of times";
}

}  // namespace
}  // namespace facenav::steps
