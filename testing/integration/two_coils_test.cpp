// Two coils in one recording, and a session without cameras, from the command line.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <opencv2/aruco.hpp>
#include <thread>

#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/core/csv_table.h"
#include "support/ball_case.h"
#include "support/ball_targets.h"
#include "support/command_line.h"
#include "support/igtl_sender.h"
#include "support/matchers.h"
#include "unit/track/coil_tracking/coil_scene.h"

namespace facenav::testing {
namespace {

namespace scene = coil_tracking::testing;
using ::testing::HasSubstr;

class TwoCoils : public ::testing::Test {
 protected:
  TwoCoils() {
    capture::RecordingWriter writer(folder_.path() / "film", scene::roomRig());
    for (int i = 0; i < 3; ++i) {
      auto frame = scene::renderMarkers(scene::roomRig(),
                                        {{scene::arucoPrint(cv::aruco::DICT_4X4_50, 7), 60, pose(0, i)},
                                         {scene::arucoPrint(cv::aruco::DICT_4X4_50, 8), 60, pose(1, i)}});
      frame.number = i;
      frame.captured = {i / 30.0};
      writer.add(frame);
    }
    writer.close();
    writeCoil("a.json", "A", 7);
    writeCoil("b.json", "B", 8);
    writeCoil("same.json", "C", 7);
  }
  /// Two prints side by side; the second one moves away from the first.
  static RigidTransform<Camera, Marker> pose(int coil, int frame) {
    return scene::markerPose(600 + 20 * coil, 15 + 10 * coil, 40 - 90 * coil, 10,
                             {coil ? 70.0 + 4 * frame : -70.0, 0.0});
  }
  void writeCoil(const std::string& file, const std::string& name, int id) const {
    std::ofstream(folder_.path() / file)
        << R"({"name": ")" << name << R"(", "marker": {"dictionary": "4x4_50", "id": )" << id
        << R"(, "size_mm": 60}, "marker_T_coil": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})";
  }
  std::string at(const std::string& name) const { return "'" + (folder_.path() / name).string() + "'"; }
  /// Largest error of a table's coil, mm.
  double error_mm(const std::string& table, int coil) const {
    double worst_mm = 0;
    int tracked = 0;
    for (const auto& row : casefile::readPoses(folder_.path() / table)) {
      if (row.object != casefile::PoseObject::coil || !row.pose) continue;
      ++tracked;
      const auto truth = pose(coil, int(row.frame));
      worst_mm = std::max(worst_mm, (row.pose->translation() - truth.translation_mm()).norm());
    }
    return tracked == 3 ? worst_mm : 1e9;
  }
  TemporaryFolder folder_;
};

TEST_F(TwoCoils, AreNamedByTheirMarkersInEitherOrder) {
  auto result = runFacenav("track " + at("film") + " --coil " + at("a.json") + " --coil " + at("b.json") +
                           " -o " + at("p.csv"));
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_LT(error_mm("p.csv", 0), 0.3);
  EXPECT_LT(error_mm("p_coil2.csv", 1), 0.3);
  EXPECT_THAT(readText(folder_.path() / "p_coil2.csv"), HasSubstr(",coil,,B\n"));
  EXPECT_THAT(result.output, HasSubstr("second coil 'B' tracked in 3 frames"));
  result = runFacenav("track " + at("film") + " --coil " + at("b.json") + " --coil " + at("a.json") + " -o " +
                      at("q.csv"));
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_LT(error_mm("q.csv", 1), 0.3);
  EXPECT_LT(error_mm("q_coil2.csv", 0), 0.3);
  EXPECT_EQ(readText(folder_.path() / "p.csv").find(",coil,B"), std::string::npos)
      << "its columns are as before";
}

TEST_F(TwoCoils, TheSameMarkerIsRefusedInOneLine) {
  const auto result = runFacenav("track " + at("film") + " --coil " + at("a.json") + " --coil " +
                                 at("same.json") + " -o " + at("p.csv"));
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.errors, HasSubstr("carries the same marker as 'A' (4x4_50 id 7)"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "p.csv"));
  const std::string two = " --coil " + at("a.json") + " --coil " + at("b.json");
  const std::string session = "track " + at("film") + " --case " + at("case") + " -o " + at("p.csv") + two;
  for (const std::string& words :
       {session + " --coil " + at("same.json"), session + " --pulses keyboard",
        session + " --pulses keyboard --pulse-coil C", session + " --pulse-coil A",
        "track " + at("film") + " --coil " + at("a.json") + " --pulses keyboard --pulse-coil A --case " +
            at("case") + " -o " + at("p.csv")})
    EXPECT_EQ(runFacenav(words).status, 2) << words;
}

/// A case with a target on top of the ball, and another tracker that shows head and coil.
class WithoutCameras : public ::testing::Test {
 protected:
  WithoutCameras() {
    const auto store = casefile::CaseStore::create(folder_.path() / "case", ballWithBrain(), {}, false);
    guidance::TreatmentPlan plan;
    plan.targets = {targetOnTop("M1")};
    store.setTargets(plan);
    casefile::signOff(store, {"XY", "", true});
    std::ofstream alignment(folder_.path() / "alignment.json");
    alignment << R"({"error_mm": 1.5, "mri_T_subject": [)";
    const Eigen::Matrix4d mri_T_subject = subject_T_mri().inverse().matrix();
    for (int i = 0; i < 16; ++i) alignment << (i ? "," : "") << mri_T_subject(i / 4, i % 4);
    alignment << "]}";
  }
  static Eigen::Isometry3d subject_T_mri() {
    Eigen::Isometry3d pose(Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, -1).normalized()));
    pose.translation() = Eigen::Vector3d(40, -110, 20);
    return pose;
  }
  /// The head in the tracker's volume, moving with time.
  static Eigen::Isometry3d tracker_T_subject(double t_s) {
    Eigen::Isometry3d pose(Eigen::AngleAxisd(1.0 + 0.1 * std::sin(3 * t_s), Eigen::Vector3d::UnitY()));
    pose.translation() = Eigen::Vector3d(100 + 20 * std::sin(2 * t_s), 50, 1200);
    return pose;
  }
  /// The coil is held 3 mm beside the target, whatever the head does.
  static Eigen::Isometry3d tracker_T_coil(double t_s) {
    Eigen::Isometry3d mri_T_coil = Eigen::Isometry3d::Identity();
    mri_T_coil.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
    mri_T_coil.translation() = Eigen::Vector3d(3, 0, 92);
    return tracker_T_subject(t_s) * subject_T_mri() * mri_T_coil;
  }
  std::string at(const std::string& name) const { return "'" + (folder_.path() / name).string() + "'"; }
  /// Runs a session while the tracker sends poses at 50 Hz; `change` may spoil the coil's pose.
  CommandResult run(const std::string& more,
                    const std::function<Eigen::Isometry3d(Eigen::Isometry3d)>& change) {
    IgtlSender tracker;
    std::atomic<bool> is_over{false};
    std::thread sender([&] {
      if (!tracker.isConnected()) return;
      for (int i = 1; !is_over; ++i) {
        const auto stamp = links::igtlStamp(std::chrono::system_clock::now());
        tracker.sendPose("SubjectToTracker", tracker_T_subject(0.02 * i), stamp);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));  // the coil's message is late
        tracker.sendPose("Coil1ToTracker", change(tracker_T_coil(0.02 * i)), stamp);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    });
    const auto result = runFacenav("guide " + at("case") + " --tracker " + tracker.words("Coil1ToTracker") +
                                   " --tracker-head SubjectToTracker --tracker-alignment " +
                                   at("alignment.json") + " --target M1 -o " + at("g.csv") + " " + more);
    is_over = true;
    sender.join();
    return result;
  }
  TemporaryFolder folder_;
};

TEST_F(WithoutCameras, HeadAndCoilOfAnotherTrackerAreGuided) {
  const auto result = run("--seconds 1.5", [](const auto& pose) { return pose; });
  ASSERT_EQ(result.status, 0) << result.errors;
  const CsvTable table(folder_.path() / "g.csv");
  int guided = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text(row, table.column("state")) == "lost") continue;
    ++guided;
    EXPECT_NEAR(table.number(row, table.column("distance_mm")), 3.0, 0.05)
        << "of one moment, though the head moves";
  }
  EXPECT_GT(guided, 20);
}

TEST_F(WithoutCameras, AMirroredCoilIsLostAndSaid) {
  const auto result = run("--seconds 0.8", [](Eigen::Isometry3d pose) {
    pose.linear().col(0) *= -1;
    return pose;
  });
  ASSERT_EQ(result.status, 0) << result.errors;
  const CsvTable table(folder_.path() / "g.csv");
  for (std::size_t row = 0; row < table.rows(); ++row)
    EXPECT_EQ(table.text(row, table.column("state")), "lost");
  EXPECT_THAT(result.errors, HasSubstr("the pose Coil1ToTracker: is mirrored"));
}

TEST_F(WithoutCameras, WithoutAnAlignmentOrWithCamerasItIsWrongUsage) {
  const std::string verb = "guide " + at("case") + " --target M1 -o " + at("g.csv") +
                           " --tracker igtl://127.0.0.1:9/Coil1ToTracker ";
  for (const char* words : {"", "--tracker-head SubjectToTracker", "--tracker-alignment a.json"})
    EXPECT_EQ(runFacenav(verb + words).status, 2) << words;
  EXPECT_EQ(runFacenav(verb + "--tracker-head S --tracker-alignment a.json --live R").status, 2);
  std::ofstream(folder_.path() / "mirrored.json")
      << R"({"error_mm": 1, "mri_T_subject": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})";
  const auto refused =
      runFacenav(verb + "--tracker-head S --tracker-alignment " + at("mirrored.json") + " --seconds 1");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors, HasSubstr("mri_T_subject"));
}

}  // namespace
}  // namespace facenav::testing
