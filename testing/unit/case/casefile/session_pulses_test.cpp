#include "facenav/casefile/session_pulses.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/pulse_file.h"
#include "facenav/casefile/session_log.h"
#include "facenav/core/csv_table.h"
#include "facenav/core/error.h"
#include "facenav/core/utc_time.h"
#include "facenav/core/whole_file.h"
#include "made_pulse.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

namespace fs = std::filesystem;
using facenav::testing::TemporaryFolder;
using ::testing::HasSubstr;

class SessionPulsesTest : public ::testing::Test {
 protected:
  SessionPulsesTest() {
    PulseFile file(folder_.path());
    for (const auto& pulse : {madePulse(1), madePulse(2, 3.5), madeLostPulse(3)}) file.keep(pulse);
  }
  SessionPulses read() const { return readSessionPulses(folder_.path()); }
  TemporaryFolder folder_;
};

TEST_F(SessionPulsesTest, AnExcludedPulseStaysAndCanBeTakenInAgain) {
  editPulse(folder_.path(), {2, true, "the patient, \"moved\"", "AB"});
  auto session = read();
  ASSERT_EQ(session.pulses.size(), 3u);
  EXPECT_TRUE(session.pulses[1].is_excluded);
  EXPECT_EQ(session.pulses[1].note, "the patient, \"moved\"");
  EXPECT_FALSE(session.pulses[0].is_excluded);
  editPulse(folder_.path(), {2, false, "", "AB"});
  session = read();
  EXPECT_FALSE(session.pulses[1].is_excluded);
  EXPECT_EQ(session.pulses[1].note, "");
  const std::string history = readWholeFile(folder_.path() / "pulse_edits.jsonl");
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 2) << "the history stays";
}

TEST_F(SessionPulsesTest, AnExclusionNeedsAPulseAndAReason) {
  EXPECT_THROW(editPulse(folder_.path(), {4, true, "why", ""}), Error);
  EXPECT_THROW(editPulse(folder_.path(), {1, true, "  ", ""}), Error);
  EXPECT_THROW(editPulse(folder_.path(), {1, false, "", ""}), Error) << "it is not excluded";
  EXPECT_FALSE(fs::exists(folder_.path() / "pulse_edits.jsonl"));
}

TEST_F(SessionPulsesTest, AnMepEnteredLaterReplacesWhatThePulseHadAndCanBeTakenBack) {
  editMeps(folder_.path(), {{1, 350.0, 22.5, "typed", "AB"}, {2, 0.0, {}, "typed", "AB"}});
  auto session = read();
  EXPECT_EQ(session.pulses[0].pulse.mep_uv, 350.0);
  EXPECT_EQ(session.pulses[0].pulse.latency_ms, 22.5);
  EXPECT_EQ(session.pulses[1].pulse.mep_uv, 0.0) << "no response is a value";
  EXPECT_EQ(session.edited_meps, (std::set<int>{1, 2}));
  editMeps(folder_.path(), {{1, {}, {}, "", ""}});
  EXPECT_FALSE(read().pulses[0].pulse.mep_uv);
  const std::string history = readWholeFile(folder_.path() / "pulse_edits.jsonl");
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 3) << "the history stays";
}

TEST_F(SessionPulsesTest, ImpossibleMepsAreRefusedAndThenNoneIsWritten) {
  const double nan = std::nan("");
  for (const MepEdit& wrong :
       {MepEdit{9, 100.0, {}, "", ""}, MepEdit{2, -1.0, {}, "", ""}, MepEdit{2, 60000.0, {}, "", ""},
        MepEdit{2, nan, {}, "", ""}, MepEdit{2, 100.0, -3.0, "", ""}})
    EXPECT_THROW(editMeps(folder_.path(), {{1, 350.0, {}, "", ""}, wrong}), Error);
  EXPECT_FALSE(fs::exists(folder_.path() / "pulse_edits.jsonl"));
}

TEST_F(SessionPulsesTest, SeveralExclusionsAreWrittenTogetherOrNotAtAll) {
  EXPECT_THROW(editPulses(folder_.path(), {{1, true, "moved", ""}, {1, true, "moved", ""}}), Error);
  EXPECT_FALSE(fs::exists(folder_.path() / "pulse_edits.jsonl"));
  editPulses(folder_.path(), {{1, true, "moved", ""}, {3, true, "moved", ""}});
  const auto session = read();
  EXPECT_TRUE(session.pulses[0].is_excluded && !session.pulses[1].is_excluded &&
              session.pulses[2].is_excluded);
}

TEST_F(SessionPulsesTest, AChangeOfALaterVersionIsSkipped) {
  std::ofstream(folder_.path() / "pulse_edits.jsonl")
      << R"({"utc":"","pulse":1,"change":"exclude","reason":"moved","by":""})"
      << "\n"
      << R"({"utc":"","pulse":1,"change":"rename","to":"x"})"
      << "\n"
      << R"({"utc":"","pulse":"one","change":"mep"})"
      << "\n";
  const auto session = read();
  EXPECT_TRUE(session.pulses[0].is_excluded) << "an unknown change is no inclusion";
  ASSERT_EQ(session.problems.size(), 1u);
  EXPECT_THAT(session.problems[0], HasSubstr("the change is left out"));
}

TEST_F(SessionPulsesTest, CsvHasTheColumnsOfTheContractAndEmptyMeansNotKnown) {
  editPulse(folder_.path(), {2, true, "moved,\nthen \"slipped\"", ""});
  const fs::path path = folder_.path() / "pulses.csv";
  writeWholeFile(path, pulsesCsv(read().pulses));
  const std::string content = readWholeFile(path);
  EXPECT_EQ(content.substr(0, content.find('\n')),
            "pulse,t_s,utc,source,target,status,reason,tx,ty,tz,qw,qx,qy,qz,distance_mm,lateral_mm,depth_mm,"
            "tilt_deg,twist_deg,gap_mm,predicted_error_mm,intensity_pct,e_target_v_per_m,mep_uv,latency_ms,"
            "excluded,note,coil,gap_stereo_mm,field_lost_pct,error_bound_mm,in_pause,"
            "e_target_v_per_m_per_a_per_us,e_max_v_per_m,e_max_v_per_m_per_a_per_us,e_max_x_mm,e_max_y_mm,"
            "e_max_z_mm,field_tier,field_coil");
  const CsvTable table(path);
  ASSERT_EQ(table.rows(), 3u);
  const auto text = [&](std::size_t row, const char* column) {
    return table.text(row, table.column(column));
  };
  const auto number = [&](std::size_t row, const char* column) {
    return table.number(row, table.column(column));
  };
  EXPECT_EQ(text(0, "status"), "on_target");
  EXPECT_EQ(text(0, "target"), "M1, \"hand\"");
  EXPECT_EQ(text(0, "utc"), "2026-11-23T14:05:09.123Z");
  const auto mri_T_coil = *madePulse(1).mri_T_coil();
  EXPECT_NEAR(number(0, "tx"), mri_T_coil.translation_mm().x(), 1e-4);
  EXPECT_NEAR(number(0, "qw"), mri_T_coil.quaternion().w(), 1e-8);
  EXPECT_NEAR(number(0, "t_s"), 10.1, 1e-9);
  EXPECT_EQ(text(0, "gap_mm"), "");
  EXPECT_EQ(text(0, "in_pause"), "0");
  EXPECT_EQ(text(0, "mep_uv"), "");
  EXPECT_EQ(text(0, "excluded"), "0");
  EXPECT_EQ(text(1, "status"), "outside");
  EXPECT_EQ(text(1, "excluded"), "1");
  EXPECT_EQ(text(1, "note"), "moved, then \"slipped\"");
  EXPECT_EQ(text(2, "status"), "lost");
  EXPECT_EQ(text(2, "reason"), "face covered");
  for (const char* column : {"target", "tx", "qz", "distance_mm", "twist_deg", "predicted_error_mm"})
    EXPECT_EQ(text(2, column), "") << column;
}

TEST(KeptSession, ASessionOfAnEarlierVersionStillCountsItsPulses) {
  const TemporaryFolder folder;
  {
    SessionLog log(folder.path());
    log.addEvent("session started");
    log.addEvent("pulse", "1, on_target, 0.8 mm, 2 deg");
    log.addEvent("pulse", "2, adjust, 4.0 mm, 2 deg");
    log.addEvent("pulse", "3, lost");
  }
  const auto session = readSession(findSession(folder.path(), ""));
  ASSERT_EQ(session.pulses.pulses.size(), 3u);
  EXPECT_EQ(session.pulses.pulses[0].pulse.status, PulseStatus::on_target);
  EXPECT_EQ(session.pulses.pulses[1].pulse.status, PulseStatus::outside);
  EXPECT_EQ(session.pulses.pulses[2].pulse.status, PulseStatus::lost);
  EXPECT_FALSE(session.pulses.pulses[0].pulse.mri_T_coil());
  EXPECT_TRUE(secondsOfUtc(session.pulses.pulses[0].pulse.utc));
  EXPECT_FALSE(session.duration_s);
  EXPECT_FALSE(session.guided);
}

TEST(KeptSession, TimesComeFromTheTablesAndAGapCountsAsLost) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "guidance.csv")
      << "frame,t_s,target,state,distance_mm\n"
      << "0,10.0,\"M1, hand\",on_target,1\n1,10.1,\"M1, hand\",adjust,3\n2,10.3,\"M1, hand\",lost,\n"
      << "3,10.4,\"M1, hand\",on_target,1\n4,12.4,\"M1, hand\",on_target,1\n5,12.5,\"M1";
  std::ofstream(folder.path() / "poses.csv")
      << "frame,t_s,object\n0,10.0,head\n0,10.0,coil\n4,12.4,head\n4,1";
  const auto session = readSession(folder.path());
  ASSERT_TRUE(session.guided);
  EXPECT_NEAR(session.guided->on_target_s, 0.1 + 0.25, 1e-9);
  EXPECT_NEAR(session.guided->adjust_s, 0.2, 1e-9);
  EXPECT_NEAR(session.guided->lost_s, 0.1, 1e-9) << "nobody was guided in the break of 2 s";
  ASSERT_TRUE(session.duration_s);
  EXPECT_NEAR(*session.duration_s, 2.4, 1e-9);
}

TEST(KeptSession, IsFoundByItsNameOrHowItBeginsAndElseTheNewestIsMeant) {
  const TemporaryFolder folder;
  EXPECT_THROW(findSession(folder.path(), ""), Error);
  for (const char* name : {"20261120T090000Z", "20261123T140509Z", "20261123T140509Z_2"})
    fs::create_directories(folder.path() / "sessions" / name);
  EXPECT_EQ(findSession(folder.path(), "").filename(), "20261123T140509Z_2");
  EXPECT_EQ(findSession(folder.path(), "newest").filename(), "20261123T140509Z_2");
  EXPECT_EQ(findSession(folder.path(), "20261120").filename(), "20261120T090000Z");
  EXPECT_EQ(findSession(folder.path(), "20261123T140509Z").filename(), "20261123T140509Z");
  EXPECT_THROW(findSession(folder.path(), "20261123"), Error);
  EXPECT_THROW(findSession(folder.path(), "../sessions"), Error);
}

TEST(UtcTime, TextAndSecondsAgree) {
  const auto time = std::chrono::system_clock::time_point(std::chrono::milliseconds(1795443909123));
  EXPECT_EQ(isoUtc(time), "2026-11-23T14:25:09.123Z");
  EXPECT_NEAR(*secondsOfUtc(isoUtc(time)), 1795443909.123, 1e-6);
  EXPECT_NEAR(*secondsOfUtc("20261123T142509Z"), 1795443909, 1e-6);
  EXPECT_FALSE(secondsOfUtc("20261123"));
  EXPECT_FALSE(secondsOfUtc("yesterday"));
}

}  // namespace
}  // namespace facenav::casefile
