// A session without cameras in the window: another tracker's head and coil by OpenIGTLink, aligned by points
// that are touched on the head.

#include <gmock/gmock.h>

#include <QPushButton>
#include <QSettings>
#include <atomic>
#include <thread>

#include "facenav/casefile/landmarks_file.h"
#include "support/igtl_sender.h"
#include "treat/tracker_panel.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;
using ::testing::HasSubstr;

constexpr double kSkin_mm = 90;  // of the ball

/// The tool on the head, and the truth of its alignment.
Eigen::Isometry3d trackerFromHead() {
  Eigen::Isometry3d pose =
      Eigen::Translation3d(100, -50, 1500) * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY());
  return pose;
}
Eigen::Isometry3d headFromMri() {
  Eigen::Isometry3d pose =
      Eigen::Translation3d(0, -20, 130) * Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitX());
  return pose;
}

/// A server that sends head, coil and pointer 50 times a second.
class MovingTracker {
 public:
  ~MovingTracker() {
    is_ended_ = true;
    thread_.join();
  }
  /// Sets where the pointer's tip is, in the MRI.
  void pointAt(const Eigen::Vector3d& p_mm) {
    place_ = p_mm.x() > 0 ? 1 : p_mm.x() < 0 ? 2 : p_mm.z() > 0 ? 3 : 0;
  }
  const testing::IgtlSender& sender() const { return sender_; }

 private:
  void run() {
    const Eigen::Vector3d places[] = {
        {0, kSkin_mm, 0}, {kSkin_mm, 0, 0}, {-kSkin_mm, 0, 0}, {0, 0, kSkin_mm}};
    while (!is_ended_) {
      sender_.acceptOne();
      const Eigen::Isometry3d tracker_T_mri = trackerFromHead() * headFromMri();
      Eigen::Isometry3d coil = Eigen::Isometry3d::Identity();
      coil.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
      coil.translation() = Eigen::Vector3d(0, 0, kSkin_mm + 4);
      Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();
      tip.translation() = places[place_];
      const auto stamp = links::igtlStamp(std::chrono::system_clock::now());
      sender_.sendPose("SubjectToTracker", trackerFromHead(), stamp);
      sender_.sendPose("Coil1ToTracker", tracker_T_mri * coil, stamp);
      sender_.sendPose("PointerToTracker", tracker_T_mri * tip, stamp);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  testing::IgtlSender sender_;
  std::atomic<int> place_{0};
  std::atomic<bool> is_ended_{false};
  std::thread thread_{[this] { run(); }};
};

class WindowTracker : public ::testing::Test {
 protected:
  WindowTracker() : treat_(services_, model_, tasks_) {
    QSettings().clear();
    QObject::connect(&treat_, &TreatPresenter::refused, [this](const QString& words) { refusal_ = words; });
    const auto folder = plannedCase(folder_.path(), true);
    surface::ScalpLandmarks landmarks;
    const std::pair<surface::Landmark, Eigen::Vector3d> places[] = {
        {surface::Landmark::nasion, {0, kSkin_mm, 0}},
        {surface::Landmark::tragus_right, {kSkin_mm, 0, 0}},
        {surface::Landmark::tragus_left, {-kSkin_mm, 0, 0}}};
    for (const auto& [which, p_mm] : places) {
      landmarks[which] = surface::ScalpLandmark{};
      landmarks[which]->point = Point<Mri>(p_mm);
    }
    casefile::writeLandmarks(landmarks, folder);
    TaskMonitor monitor;
    model_.open(loadCase(folder, monitor));
  }
  void settle() {
    ASSERT_TRUE(fixtures::waitFor([this] { return !tasks_.isRunning(); }));
  }
  testing::TemporaryFolder folder_;
  Services services_ = fakeServices();
  CaseModel model_;
  TaskRunner tasks_;
  TreatPresenter treat_;
  QString refusal_;
};

TEST_F(WindowTracker, WordsThatAreNoTrackerAreRefused) {
  auto& tracker = treat_.tracker();
  tracker.choose({"igtl:/nowhere", "SubjectToTracker", {}, {}});
  EXPECT_FALSE(tracker.open());
  EXPECT_FALSE(refusal_.isEmpty());
  tracker.choose({"igtl://127.0.0.1/Same", "Same", {}, {}});
  EXPECT_FALSE(tracker.open());
  EXPECT_THAT(refusal_.toStdString(), HasSubstr("same name"));
  EXPECT_FALSE(treat_.hasRecording());
}

TEST_F(WindowTracker, ItIsAlignedByTouchedPoints) {
  MovingTracker room;
  auto& tracker = treat_.tracker();
  TrackerPanel panel(treat_);
  tracker.choose({room.sender().words("Coil1ToTracker"), "SubjectToTracker", {}, {}});
  ASSERT_TRUE(tracker.open()) << refusal_.toStdString();
  EXPECT_TRUE(treat_.hasTracker());
  EXPECT_FALSE(treat_.canAlign()) << "its alignment is not known yet";
  ASSERT_TRUE(fixtures::waitFor([&] { return tracker.isWell(); })) << tracker.words().toStdString();
  EXPECT_EQ(tracker.words(), "the head is seen; the coil is seen");
  EXPECT_EQ(tracker.landmarks(), (QStringList{"nasion", "tragus-left", "tragus-right"}));
  tracker.touch("nasion", "NobodyToTracker");
  EXPECT_THAT(refusal_.toStdString(), HasSubstr("the pointer"));
  const std::pair<const char*, Eigen::Vector3d> touches[] = {
      {"nasion", {0, 1, 0}}, {"tragus-right", {1, 0, 0}}, {"tragus-left", {-1, 0, 0}}};
  for (const auto& [name, side] : touches) {
    room.pointAt(side);
    fixtures::waitFor([] { return false; }, 100);  // the pose has come
    tracker.touch(name, "PointerToTracker");
    EXPECT_TRUE(tracker.isTouched(name));
  }
  tracker.alignByPoints(2);
  ASSERT_TRUE(tracker.hasAlignment()) << refusal_.toStdString();
  ASSERT_TRUE(treat_.canAlign());
  treat_.align(false);
  settle();
  ASSERT_TRUE(treat_.isAligned()) << refusal_.toStdString();
  EXPECT_THAT(treat_.alignmentWords().toStdString(), HasSubstr("aligned"));
  EXPECT_THAT(treat_.recordingWords().toStdString(), HasSubstr("another tracker"));
  tracker.close();
  EXPECT_FALSE(treat_.hasRecording());
}

TEST_F(WindowTracker, ASessionFollowsItsHeadAndCoil) {
  std::optional<MovingTracker> room;
  room.emplace();
  auto& tracker = treat_.tracker();
  const auto file = folder_.path() / "alignment.json";
  std::vector<steps::TouchedPoint> points;
  const Eigen::Vector3d places[] = {{0, kSkin_mm, 0}, {kSkin_mm, 0, 0}, {-kSkin_mm, 0, 0}, {0, 0, kSkin_mm}};
  for (const auto& p_mm : places)
    points.push_back({std::to_string(points.size()), Point<Mri>(p_mm), headFromMri() * p_mm});
  steps::writeTouchedPoints(points, 2, file);
  tracker.choose({room->sender().words("Coil1ToTracker"), "SubjectToTracker", {}, file});
  ASSERT_TRUE(tracker.open());
  treat_.align(false);
  settle();
  ASSERT_TRUE(treat_.isAligned()) << refusal_.toStdString();
  treat_.start();
  settle();
  ASSERT_TRUE(treat_.isRunning()) << refusal_.toStdString();
  const auto mriFromCoil = [this]() -> std::optional<Eigen::Vector3d> {
    const auto state = treat_.state();
    if (!state->camera_T_mri || !state->camera_T_coil) return std::nullopt;
    return (state->camera_T_mri->inverse() * *state->camera_T_coil).translation_mm();
  };
  ASSERT_TRUE(fixtures::waitFor([&] { return mriFromCoil().has_value(); })) << tracker.words().toStdString();
  EXPECT_LT((mriFromCoil().value_or(Eigen::Vector3d::Zero()) - Eigen::Vector3d(0, 0, kSkin_mm + 4)).norm(),
            0.01);
  room.reset();
  EXPECT_TRUE(fixtures::waitFor([&] { return !mriFromCoil(); })) << "no pose outlives its tracker";
  treat_.end();
}

}  // namespace
}  // namespace facenav::ui
