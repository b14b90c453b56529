// Return near home, from the command line: a first visit in the virtual room, the expert's pose of it, the
// case as one file without the MRI, and a later visit with another capture, expression and seat. The room's
// truth gives the return error.

#include <gmock/gmock.h>

#include <set>
#include <thread>

#include "facenav/capture/recording.h"
#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/zip_file.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/geometry/rotation.h"
#include "support/command_line.h"
#include "support/conversation.h"
#include "support/pulse_sender.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const char* const kName = "Jane Doe";

class ReturnPath : public ::testing::Test {
 protected:
  void SetUp() override {
    FACENAV_NEEDS(virtualPatientMri());
    ::signal(SIGPIPE, SIG_IGN);
    if (!made_) makeVisits();
    for (const auto& [name, to] : {std::pair{"case", case_}, {"first", first_}, {"later", later_}})
      fs::copy(made_->path() / name, to, fs::copy_options::recursive);
  }
  static void TearDownTestSuite() { made_.reset(); }
  /// Makes the case and the recordings of both visits, once for all tests.
  void makeVisits() {
    made_ = std::make_unique<TemporaryFolder>();
    const fs::path made = made_->path() / "case";
    run("prepare '" + virtualPatientMri().string() + "' -o " + in(made) + " --label '" + kName + "' -q");
    run("check " + in(made) + " --by AB --acknowledge-findings");
    run("target " + in(made) + " --name 'M1 hand L' --mni -37 -21 58");
    simulate(made_->path() / "first", "--seed 1");
    simulate(made_->path() / "later",
             "--seed 7 --seat-turn-deg 4 --seat-shift-mm 15 --capture-grimace 0.4 --hair-sway-mm 3");
  }
  static std::string in(const fs::path& path) { return "'" + path.string() + "'"; }
  CommandResult run(const std::string& words, int status = 0) const {
    const auto result = runFacenav(words, 200);
    EXPECT_EQ(result.status, status) << words << "\n" << result.errors;
    return result;
  }
  void simulate(const fs::path& recording, const std::string& how) const {
    run("simulate treatment --case " + in(made_->path() / "case") + " --frames 24 --frames-per-s 12 " + how +
        " -o " + in(recording) + " -q");
  }
  /// Returns pulses given while the coil rests on the target, in the last third of the recording.
  std::vector<casefile::ReviewedPulse> treat(const fs::path& case_folder, const fs::path& recording) {
    Conversation facenav({"track", recording.string(), "--case", case_folder.string(), "--coil",
                          (recording / "coil.json").string(), "--pulses", sender_.source(), "--commands",
                          "-q", "-o", (folder_.path() / "poses.csv").string()});
    const auto begun = facenav.hearWithin(60);
    EXPECT_TRUE(begun && begun->contains("session"));
    for (int i = 0; i < 24; ++i) {
      sender_.send(50);
      std::this_thread::sleep_for(std::chrono::milliseconds(90));
    }
    while (facenav.hearWithin(20)) {
    }
    facenav.end();
    return casefile::readSession(casefile::findSession(case_folder, "")).pulses.pulses;
  }
  /// Return error: true coil pose when it is measured exactly at the expert's pose, against the expert's true
  /// coil pose; median over the pulses on target.
  struct Off {
    std::size_t pulses = 0;
    double mm = 0, deg = 0;
  };
  Off distanceFromExpert(const std::vector<casefile::ReviewedPulse>& pulses) const;
  static inline std::unique_ptr<TemporaryFolder> made_;
  TemporaryFolder folder_;
  fs::path case_ = folder_.path() / "case", home_ = folder_.path() / "home",
           file_ = folder_.path() / "to_go.zip", first_ = folder_.path() / "first",
           later_ = folder_.path() / "later";
  PulseSender sender_;
};

/// Reduces a recording to that of two webcams alone: one plain pair in which the coil rests at the head, its
/// marker seen by both.
void removeProjector(const fs::path& recording) {
  const auto capture = recording / "capture";
  fs::remove(capture / "pattern_left.png");
  fs::remove(capture / "pattern_right.png");
  for (const char* side : {"left", "right"}) {
    std::set<fs::path> film;
    for (const auto& entry : fs::directory_iterator(recording / side)) film.insert(entry.path());
    fs::copy_file(*film.rbegin(), capture / (std::string("plain_") + side + ".png"),
                  fs::copy_options::overwrite_existing);
  }
}

/// True pose of the coil against the MRI at the recording's end.
RigidTransform<Mri, Coil> trueCoil(const fs::path& recording) {
  const auto head = capture::readTruth(recording / "truth" / "head.csv"),
             marker = capture::readTruth(recording / "truth" / "coil.csv");
  const auto last = head.rbegin()->first;
  return RigidTransform<Camera, Mri>::fromIsometry(head.at(last)).inverse() *
         RigidTransform<Camera, Marker>::fromIsometry(marker.at(last)) *
         coil_tracking::readCoil(recording / "coil.json").marker_T_coil();
}

ReturnPath::Off ReturnPath::distanceFromExpert(const std::vector<casefile::ReviewedPulse>& pulses) const {
  std::vector<double> off_mm, off_deg;
  const auto expert =
      casefile::CaseStore::open(home_).targets().targets.front().mri_T_target.reframe<Mri, Coil>();
  for (const auto& reviewed : pulses) {
    if (reviewed.pulse.status != casefile::PulseStatus::on_target) continue;
    const auto there = trueCoil(later_) * reviewed.pulse.mri_T_coil()->inverse() * expert;
    const auto error = poseError(trueCoil(first_), there);
    off_mm.push_back(error.translation_mm), off_deg.push_back(error.rotation_rad * kDegPerRad);
  }
  if (off_mm.empty()) return {};
  return {off_mm.size(), upperMedian(off_mm), upperMedian(off_deg)};
}

TEST_F(ReturnPath, ACaseGoesHomeWithoutItsMriAndComesBackToTheExpertsPose) {
  treat(case_, first_);
  const auto stored =
      nlohmann::json::parse(run("target " + in(case_) + " --from-session newest --json").output);
  EXPECT_EQ(stored["name"], "expert M1 hand L");
  EXPECT_LT(stored["spread_mm"].get<double>(), 1);
  run("export " + in(case_) + " --as home --coil " + in(first_ / "coil.json") + " -o " + in(file_));
  for (const auto& [name, content] : readZip(file_)) {
    EXPECT_THAT(content, Not(HasSubstr(kName))) << name;
    EXPECT_THAT(name, Not(HasSubstr(".nii")));
  }
  run("import " + in(home_) + " " + in(file_));

  const auto off = distanceFromExpert(treat(home_, later_));
  ASSERT_GE(off.pulses, 3u);
  EXPECT_LT(off.mm, 1.0) << "the goal, mm";
  EXPECT_LT(off.deg, 1.0) << "the goal, deg";
  EXPECT_THAT(run("sessions " + in(home_)).output, HasSubstr("202"));
  run("report " + in(home_) + " -o " + in(folder_.path() / "report.html"));
  EXPECT_THAT(run("plan " + in(home_), 1).errors, HasSubstr("holds no MRI"));
}

TEST_F(ReturnPath, TwoCamerasWithoutAProjectorAreEnoughAtBothVisits) {
  for (const auto& recording : {first_, later_}) removeProjector(recording);
  treat(case_, first_);
  ASSERT_TRUE(casefile::CaseStore::open(case_).alignment());
  EXPECT_NE(casefile::CaseStore::open(case_).alignment()->from, "dots");
  run("target " + in(case_) + " --from-session newest");
  const auto exported =
      run("export " + in(case_) + " --as home --coil " + in(first_ / "coil.json") + " -o " + in(file_));
  EXPECT_THAT(exported.output, HasSubstr("its size to"));
  run("import " + in(home_) + " " + in(file_));
  const auto off = distanceFromExpert(treat(home_, later_));
  ASSERT_GE(off.pulses, 3u);
  const auto aligned = casefile::CaseStore::open(home_).alignment();
  ASSERT_TRUE(aligned && aligned->predicted_tre_p95_mm.size() == 1);
  const double bound_mm = aligned->predicted_tre_p95_mm.begin()->second;
  std::printf("off by %.2f mm, %.2f deg; stated bound %.2f mm\n", off.mm, off.deg, bound_mm);
  EXPECT_LT(off.mm, bound_mm);
  EXPECT_LT(bound_mm, 6.0) << "a bound that says something";
  // A case without an MRI is made of the same recording; without the marker it is refused.
  run("face-case " + in(first_) + " --coil " + in(first_ / "coil.json") + " --using plain -o " +
      in(folder_.path() / "face") + " -q");
  fs::copy(first_ / "left" / "000000.png", first_ / "capture" / "plain_left.png",
           fs::copy_options::overwrite_existing);
  fs::copy(first_ / "right" / "000000.png", first_ / "capture" / "plain_right.png",
           fs::copy_options::overwrite_existing);
  for (const char* side : {"left", "right"}) fs::remove_all(first_ / side);
  fs::remove(first_ / "timestamps.csv");
  EXPECT_THAT(run("face-case " + in(first_) + " -o " + in(folder_.path() / "other"), 1).errors,
              HasSubstr("hold the coil still beside the face"));
  EXPECT_FALSE(fs::exists(folder_.path() / "other"));
}

TEST_F(ReturnPath, AFaceCaseNeedsNoMriAndRefusesWhatItCannotKnow) {
  const fs::path face = folder_.path() / "face";
  run("face-case " + in(first_) + " -o " + in(face) + " -q");
  EXPECT_THAT(run("export " + in(face) + " --as home -o " + in(file_), 1).errors,
              HasSubstr("not signed off"));
  run("check " + in(face) + " --by AB --acknowledge-findings");
  EXPECT_THAT(run("align " + in(face) + " " + in(later_), 1).errors,
              HasSubstr("confirm that this is the person whose face is stored"));
  run("align " + in(face) + " " + in(later_) + " --patient-confirmed");
  EXPECT_THAT(run("face-case " + in(later_) + " -o " + in(face), 1).errors,
              HasSubstr("exists there already"));
  // Moved cameras: the calibration is older than the knock.
  const fs::path knocked = folder_.path() / "knocked";
  fs::copy(later_, knocked, fs::copy_options::recursive);
  auto rig = cameras::readRig(knocked / "stereo.yml");
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = expRotation({0.4 * kRadPerDeg, 0, 0.2 * kRadPerDeg});
  rig.right_T_left = RigidTransform<RightCamera, Camera>::fromIsometry(turn * rig.right_T_left.isometry());
  cameras::writeRig(rig, knocked / "stereo.yml");
  EXPECT_NE(run("align " + in(face) + " " + in(knocked), 1).errors, "");
  EXPECT_NE(run("face-case " + in(knocked) + " -o " + in(folder_.path() / "other"), 1).errors, "");
  EXPECT_FALSE(fs::exists(folder_.path() / "other"));
}

}  // namespace
}  // namespace facenav::testing
