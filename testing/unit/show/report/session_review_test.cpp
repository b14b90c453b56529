#include "facenav/report/session_review.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <ctime>
#include <fstream>

#include "facenav/casefile/pulse_file.h"
#include "facenav/casefile/session_log.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/report/local_time.h"
#include "facenav/report/session_report.h"
#include "support/ball_case.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class SessionReviewTest : public ::testing::Test {
 protected:
  SessionReviewTest()
      : store_(casefile::CaseStore::create(folder_.path() / "Doe_Jane", testing::ballCase(), {}, false)) {
    store_.setLabel("Jane Doe");
    casefile::SessionLog log(store_.folder());
    session_ = log.folder();
    log.addEvent("session started");
    log.addEvent("alignment", "aligned: 0.41 mm rms over 16000 points");
    log.addEvent("coil", "figure-8 70 mm");
    for (int i = 0; i < 2; ++i) log.addEvent("face lost", "no_face");
    log.addEvent("double trigger", "keyboard");
    log.addEvent("fault", "cannot be read: /data/Doe Jane/left/000005.png, check the disk");
    casefile::PulseFile pulses(session_);
    for (int i = 1; i <= 20; ++i) pulses.keep(casefile::madePulse(i, 0.2 * i));  // 0.2 to 4.0 mm off
    pulses.keep(casefile::madeLostPulse(21));
  }
  report::SessionSummary summary() const { return report::summarise(casefile::readSession(session_)); }
  std::string report(const report::ReportOptions& options = {}) const {
    return report::sessionReport(store_, casefile::readSession(session_), options);
  }
  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  fs::path session_;
};

TEST_F(SessionReviewTest, CountsAndSpreadsAreThoseOfThePulses) {
  const auto s = summary();
  EXPECT_EQ(s.pulses, 21);
  EXPECT_EQ(s.on_target, 10);
  EXPECT_EQ(s.outside, 10);
  EXPECT_EQ(s.lost, 1);
  EXPECT_EQ(s.double_triggers, 1);
  EXPECT_EQ(s.face_losses, 2);
  EXPECT_FALSE(s.has_ended);
  ASSERT_TRUE(s.distance_mm);
  EXPECT_NEAR(s.distance_mm->median, 2.1, 1e-9);
  EXPECT_NEAR(s.distance_mm->p95, 3.8, 1e-9) << "the 19th of 20";
  EXPECT_FALSE(s.clock_set_s);
}

TEST_F(SessionReviewTest, AnExcludedPulseIsCountedApartAndEverythingIsComputedAgain) {
  for (int i = 11; i <= 20; ++i) casefile::editPulse(session_, {i, true, "moved", ""});
  const auto s = summary();
  EXPECT_EQ(s.pulses, 21);
  EXPECT_EQ(s.excluded, 10);
  EXPECT_EQ(s.outside, 0);
  EXPECT_NEAR(s.distance_mm->median, 1.1, 1e-9);
}

TEST(SessionReview, AClockThatWasSetBackIsSaidAndNothingElseChanges) {
  const testing::TemporaryFolder folder;
  casefile::PulseFile pulses(folder.path());
  for (int i = 1; i <= 3; ++i) {
    auto pulse = casefile::madePulse(i);
    pulse.steady_s = 5000.0 + 10.0 * i;
    pulse.utc = i < 3 ? "2026-11-23T14:05:" + std::to_string(10 * i) + ".000Z" : "2026-11-23T13:05:30.000Z";
    pulses.keep(pulse);
  }
  const auto s = report::summarise(casefile::readSession(folder.path()));
  ASSERT_TRUE(s.clock_set_s);
  EXPECT_NEAR(*s.clock_set_s, -3600.0, 1e-3);
  EXPECT_EQ(s.pulses, 3);
}

TEST_F(SessionReviewTest, TheListShowsASessionThatCannotBeRead) {
  fs::create_directories(store_.folder() / "sessions/20200101T000000Z/pulses.jsonl");  // a folder
  const auto sessions = report::summariseSessions(store_.folder());
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[0].started_utc, "2020-01-01T00:00:00Z");
  ASSERT_EQ(sessions[0].problems.size(), 1u);
  EXPECT_THAT(sessions[0].problems[0], HasSubstr("pulses.jsonl"));
  EXPECT_EQ(sessions[1].pulses, 21);
}

TEST_F(SessionReviewTest, TheReportHoldsTheFiguresAndSaysWhatIsNotRecorded) {
  casefile::editPulse(session_, {20, true, "patient <moved>", ""});
  const std::string page = report();
  for (const char* words :
       {"aligned: 0.41 mm rms over 16000 points", "figure-8 70 mm", "2.0 / 3.8 mm", "10 (50 %)",
        "Adverse events</td><td>not recorded", "Muscles</td><td>not recorded", "M1, &quot;hand&quot;",
        "patient &lt;moved&gt;", "face covered", "<svg"})
    EXPECT_THAT(page, HasSubstr(words));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
}

TEST_F(SessionReviewTest, TheReportNamesNobodyUnlessAsked) {
  std::ofstream(session_ / "pulses.jsonl", std::ios::app) << "{\"pulse\":22";  // its caution names a file
  const std::string page = report();
  EXPECT_THAT(page, HasSubstr(store_.caseId()));
  EXPECT_THAT(page, HasSubstr("cut short"));
  EXPECT_THAT(page, HasSubstr("cannot be read: 000005.png, check the disk"));
  EXPECT_THAT(page, Not(HasSubstr("Doe")));
  EXPECT_THAT(report({true}), HasSubstr("Jane Doe"));
}

/// A session of pulses at these times by the steady clock. The recording's clock runs 8.5 times slower, as a
/// slow machine plays it.
std::string reportOf(const std::vector<double>& times_s, const std::vector<std::string>& events = {}) {
  const testing::TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", testing::ballCase(), {}, false);
  casefile::SessionLog log(store.folder());
  log.addEvent("session started");
  for (const auto& event : events)
    log.addEvent(event.substr(0, event.find('=')), event.substr(event.find('=') + 1));
  casefile::PulseFile pulses(log.folder());
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    auto pulse = casefile::madePulse(int(i) + 1);
    pulse.steady_s = 5000.0 + times_s[i];
    pulse.t_s = 10.0 + times_s[i] / 8.5;
    pulse.error_bound_mm = 5.2;
    pulses.keep(pulse);
  }
  return report::sessionReport(store, casefile::readSession(log.folder()));
}

TEST(SessionReview, TrainsHaveTheFrequencyAtWhichPulsesWereGiven) {
  std::vector<double> times_s;
  for (int train = 0; train < 3; ++train)
    for (int i = 0; i < 12; ++i) times_s.push_back(20.0 * train + i / 2.4);
  const std::string page = reportOf(times_s);
  EXPECT_THAT(page, HasSubstr("3 trains, 12.0 pulses each on average, 2.4 Hz, pauses of 15.4 s"));
}

TEST(SessionReview, SinglePulsesAreNoTrains) {
  EXPECT_THAT(reportOf({0, 5, 10, 15}), HasSubstr("<td>4 single pulses</td>"));
  const std::string mixed = reportOf({0, 5, 5.1, 5.2, 20});
  EXPECT_THAT(mixed, HasSubstr("1 train, 3.0 pulses each on average, 10.0 Hz; 2 single pulses"));
}

TEST(SessionReview, TheAlignmentsBoundAndCautionsAreInTheReport) {
  const std::string page = reportOf({0}, {"alignment caution=a camera may have turned"});
  EXPECT_THAT(page, HasSubstr("95 % within 5.2 mm"));
  EXPECT_THAT(page, HasSubstr("a camera may have turned"));
  EXPECT_THAT(page, Not(HasSubstr("standard error")));
}

TEST(SessionReview, EndedNormallyOnlyIfItDid) {
  EXPECT_THAT(reportOf({0}, {"session ended="}), HasSubstr("ended normally"));
  for (const auto& [events, words] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{}, "not ended"},
           {{"fault=the disk is gone", "session ended="}, "stopped by a fault: the disk is gone"},
           {{"session ended=the window was closed"}, "not by the operator: the window was closed"},
           {{"session ended=", "session continued=after 1 pulses"}, "not ended"}}) {
    const std::string page = reportOf({0}, events);
    EXPECT_THAT(page, HasSubstr(words));
    EXPECT_THAT(page, Not(HasSubstr("ended normally")));
  }
  EXPECT_THAT(reportOf({0}, {"fault=no picture", "face found=", "session ended="}),
              HasSubstr("ended normally"))
      << "it had recovered";
}

TEST(SessionReview, TimesOfDayAreLocal) {
  ::setenv("TZ", "Asia/Tokyo", 1);
  ::tzset();
  for (const char* utc :
       {"2026-11-23T14:05:09.123Z", "2026-11-23T14:05:09Z", "20261123T140509Z", "20261123T140509Z_2"})
    EXPECT_EQ(report::localTimeAndZone(utc), "2026-11-23 23:05:09 (UTC+0900)") << utc;
  EXPECT_EQ(report::localClock("20261123T140509Z"), "23:05:09");
  EXPECT_EQ(report::localTime("no time"), "no time");
  ::unsetenv("TZ");
  ::tzset();
}

TEST(SessionReview, PausesAreListedWithReasonAndLength) {
  EXPECT_THAT(reportOf({0}, {"pause=coil too warm", "resume=", "pause length=151 s", "pause=equipment"}),
              HasSubstr("coil too warm (151 s); equipment (not ended)"));
}

TEST_F(SessionReviewTest, TheReportIsKeptWithTheSessionForThisUserOnly) {
  report::writeSessionReport(store_.folder(), session_);
  EXPECT_THAT(readWholeFile(session_ / "report.html"), HasSubstr("TMS session report"));
  EXPECT_EQ(fs::status(session_ / "report.html").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST(SessionReview, ASessionWithoutPulsesHasAReport) {
  const testing::TemporaryFolder folder;
  const auto store = casefile::CaseStore::create(folder.path() / "case", testing::ballCase(), {}, false);
  const fs::path session = casefile::SessionLog(store.folder()).folder();
  EXPECT_THAT(report::sessionReport(store, casefile::readSession(session)), HasSubstr("No pulse was given"));
}

}  // namespace
}  // namespace facenav::steps
