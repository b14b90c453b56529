#include "facenav/casefile/session_so_far.h"

#include <gtest/gtest.h>

#include <fstream>

#include "facenav/casefile/pulse_file.h"
#include "facenav/casefile/session_log.h"
#include "facenav/casefile/session_pulses.h"
#include "facenav/core/error.h"
#include "made_pulse.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

PoseRow frameRow(std::int64_t frame, double t_s) {
  return poseRow(frame, t_s, PoseObject::head,
                 Tracked<RigidTransform<Camera, Mri>>(Lost{LostReason::no_face}));
}

/// Makes an interrupted session: no end is recorded, and the last lines are torn.
std::filesystem::path cutOffSession(const std::filesystem::path& case_folder) {
  std::filesystem::path folder;
  {
    SessionLog log(case_folder);
    folder = log.folder();
    log.addEvent("session started");
    log.addEvent("target", "M1");
    log.addEvent("pause", "coil too warm");
    PulseFile pulses(folder);
    pulses.keep(madePulse(1));
    pulses.keep(madePulse(2, 5.0));
    log.add(frameRow(40, 0.8));
    log.add(frameRow(41, 0.82));
  }
  std::ofstream(folder / "pulses.jsonl", std::ios::app) << "{\"pulse\": 3, \"utc";
  std::ofstream(folder / "poses.csv", std::ios::app) << "42,0.8";
  return folder;
}

TEST(SessionSoFar, ACutOffSessionHasAllUpToItsLastWholeLine) {
  const testing::TemporaryFolder folder;
  const auto so_far = sessionSoFar(cutOffSession(folder.path()));
  EXPECT_EQ(so_far.last_pulse, 2);
  EXPECT_EQ(so_far.on_target, 1);
  EXPECT_EQ(so_far.outside, 1);
  EXPECT_EQ(so_far.target, "M1");
  EXPECT_TRUE(so_far.is_paused);
  EXPECT_FALSE(so_far.has_ended || so_far.is_running);
  EXPECT_EQ(so_far.last_frame, 41);
  EXPECT_DOUBLE_EQ(so_far.last_t_s, 0.82);
  EXPECT_LT(so_far.idle_s, 60);
}

TEST(SessionSoFar, GoingOnAppendsAndNumbersNoPulseTwice) {
  const testing::TemporaryFolder folder;
  const auto session = cutOffSession(folder.path());
  {
    SessionLog log = SessionLog::goOn(session);
    EXPECT_EQ(log.folder(), session);
    EXPECT_TRUE(sessionSoFar(session).is_running);
    EXPECT_THROW(SessionLog::goOn(session), Error) << "one writer at a time";
    log.addEvent("session continued");
    log.addEvent("resume");
    PulseFile(session, PulseFile::Begin::go_on).keep(madePulse(3));
    log.add(frameRow(42, 1.9));
    log.addEvent("session ended");
  }
  const auto so_far = sessionSoFar(session);
  EXPECT_EQ(so_far.last_pulse, 3);
  EXPECT_EQ(so_far.last_frame, 42);
  EXPECT_TRUE(so_far.has_ended);
  EXPECT_FALSE(so_far.is_paused || so_far.is_running);
  EXPECT_EQ(readSessionPulses(session).problems.size(), 1u) << "the torn line is named";
}

TEST(SessionSoFar, AFolderThatIsNoSessionIsRefused) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW(sessionSoFar(folder.path()), Error);
  EXPECT_THROW(SessionLog::goOn(folder.path()), Error);
  EXPECT_FALSE(newestSession(folder.path()));
}

}  // namespace
}  // namespace facenav::casefile
