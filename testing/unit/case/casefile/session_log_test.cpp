#include "facenav/casefile/session_log.h"

#include <gtest/gtest.h>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/session_track.h"
#include "facenav/core/csv_table.h"
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

/// Adds a frame with head and coil at rest, the coil on the target.
void addFrame(SessionLog& log, int frame) {
  const double t_s = 0.1 * frame;
  for (const auto object : {PoseObject::head, PoseObject::coil})
    log.add(PoseRow{frame, t_s, object, Eigen::Isometry3d::Identity(), 0.9, {}});
  guidance::GuidanceState state;
  state.state = guidance::State::on_target;
  state.values.emplace();
  state.values->distance_mm = 0.5 + frame;
  state.predicted_error_mm = 0.75;
  guidance::CoilGap gap;
  gap.by_poses_mm = 3.25;
  log.add(guidance::GuidanceRow{frame, t_s, "M1, \"hand\"", state, gap});
}

/// Keeps the first `columns` fields of each line of a table; the target's name contains one comma more.
void cutColumns(const std::filesystem::path& path, int columns) {
  std::istringstream old(readWholeFile(path));
  std::string line, cut;
  for (bool is_header = true; std::getline(old, line); is_header = false) {
    std::size_t end = std::string::npos;
    for (int i = 0; i < 13 - columns; ++i) end = line.rfind(',', end - (i > 0));
    cut += line.substr(0, end) + "\n";
  }
  writeWholeFile(path, cut);
}

TEST(SessionLog, AnOlderSessionThatGoesOnKeepsItsColumns) {
  const TemporaryFolder folder;
  std::filesystem::path session;
  {
    SessionLog log(folder.path());
    session = log.folder();
    addFrame(log, 1);
  }
  cutColumns(session / "guidance.csv", 11);  // as before the gaps were added
  {
    auto log = SessionLog::goOn(session);
    addFrame(log, 2);
  }
  const CsvTable table(session / "guidance.csv");  // refuses a line with another number of fields
  ASSERT_EQ(table.rows(), 2u);
  EXPECT_FALSE(table.findColumn("gap_mm"));
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(table.text(row, table.column("target")), "M1, \"hand\"");
    EXPECT_EQ(table.number(row, table.column("predicted_error_mm")), 0.75);
    EXPECT_EQ(table.number(row, table.column("distance_mm")), 1.5 + double(row));
  }
  const auto track = readSessionTrack(session / "poses.csv", session / "guidance.csv");
  EXPECT_TRUE(track.problems.empty());
  ASSERT_EQ(track.moments.size(), 2u);
  EXPECT_FLOAT_EQ(track.moments[1].guidance.distance_mm, 2.5f);
}

TEST(SessionLog, LinesThatOnceGotTwoFieldsMoreThanTheirHeaderAreRead) {
  const TemporaryFolder folder;
  SessionLog log(folder.path());
  addFrame(log, 1);
  addFrame(log, 2);
  const auto path = log.folder() / "guidance.csv";
  std::string text = readWholeFile(path);
  text.erase(text.find(",gap_mm,gap_stereo_mm"), std::string(",gap_mm,gap_stereo_mm").size());
  writeWholeFile(path, text);
  const auto track = readSessionTrack(log.folder() / "poses.csv", path);
  EXPECT_TRUE(track.problems.empty()) << track.problems.front();
  EXPECT_FLOAT_EQ(track.moments.at(1).guidance.distance_mm, 2.5f);
}

TEST(SessionLog, ATableWithoutItsHeaderIsNotGoneOnWith) {
  const TemporaryFolder folder;
  std::filesystem::path session;
  {
    SessionLog log(folder.path());
    session = log.folder();
    addFrame(log, 1);
  }
  const std::string before = "1,0.1,M1,lost,,,,,,,,,\n";
  writeWholeFile(session / "guidance.csv", before);
  EXPECT_THROW(SessionLog::goOn(session), Error);
  EXPECT_EQ(readWholeFile(session / "guidance.csv"), before) << "nothing was added";
}

/// The clock was set back by an hour between the pulses and the end; a person noted something afterwards.
TEST(SessionLog, EventsKeepTheirOrderWhereTheClockWasSetBack) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "events.jsonl",
                 R"({"utc":"20261124T140000Z","event":"session started","detail":""}
{"utc":"20261124T141000Z","event":"session continued","detail":""}
{"utc":"20261124T131500Z","event":"session ended","detail":""}
)");
  writeWholeFile(folder.path() / "notes.jsonl",
                 R"({"utc":"20261124T140500Z","event":"pain after","detail":"2"}
)");
  std::vector<std::string> names;
  for (const auto& event : readSession(folder.path()).events)
    if (event.event.rfind("session", 0) == 0) names.push_back(event.event);
  EXPECT_EQ(names, (std::vector<std::string>{"session started", "session continued", "session ended"}));
}

TEST(SessionLog, NeedsACaseFolder) { EXPECT_THROW(SessionLog("/nonexistent/case"), Error); }

}  // namespace
}  // namespace facenav::casefile
