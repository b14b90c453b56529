#include "facenav/casefile/session_log.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {
using facenav::testing::TemporaryFolder;

TEST(SessionLog, LinesAreThereWhileTheSessionRuns) {
  const TemporaryFolder folder;
  SessionLog log(folder.path());
  log.add(PoseRow{0, 0.0, PoseObject::coil, std::nullopt, 0.0, LostReason::no_marker});
  log.add(PoseRow{1, 0.1, PoseObject::coil, Eigen::Isometry3d::Identity(), 0.9, {}});
  log.add(guidance::GuidanceRow{1, 0.1, "M1", {}});
  log.addEvent("stimulus", "line\nbreak");
  EXPECT_EQ(readPoses(log.folder() / "poses.csv").size(), 2u);  // before the log is closed
  EXPECT_NE(readWholeFile(log.folder() / "guidance.csv").find("1,0.100000,M1,lost"), std::string::npos);
  const std::string events = readWholeFile(log.folder() / "events.jsonl");
  EXPECT_NE(events.find("\"event\":\"stimulus\",\"detail\":\"line\\nbreak\"}\n"), std::string::npos)
      << events;
  EXPECT_EQ(log.folder().parent_path(), folder.path() / "sessions");
  const auto all = std::filesystem::status(log.folder()).permissions();
  EXPECT_EQ(all, std::filesystem::perms::owner_all);
}

TEST(SessionLog, TwoSessionsInOneSecondStayApart) {
  const TemporaryFolder folder;
  const SessionLog first(folder.path()), second(folder.path());
  EXPECT_NE(first.folder(), second.folder());
}

TEST(SessionLog, NeedsACaseFolder) { EXPECT_THROW(SessionLog("/nonexistent/case"), Error); }

}  // namespace
}  // namespace facenav::casefile
