// Live cameras, replaced by a recording with the timing of live cameras: pictures, alignment, guidance,
// faults.

#include <future>

#include "cameras_fixtures.h"

namespace facenav::ui {
namespace {

using namespace cameras_fixtures;

/// Frees a window that would wait for ever for a camera that hangs.
class Rescue {
 public:
  explicit Rescue(std::shared_ptr<std::atomic<bool>> hung)
      : thread_([hung = std::move(hung), over = over_.get_future()] {
          over.wait_for(std::chrono::seconds(20));
          *hung = false;
        }) {}
  ~Rescue() {
    over_.set_value();
    thread_.join();
  }

 private:
  std::promise<void> over_;
  std::thread thread_;
};

TEST_F(CamerasTest, AlignsFromTwoPicturesOfNowAndGuides) {
  openCameras();
  EXPECT_EQ(opened_, std::make_pair(kLeft.toStdString(), kRight.toStdString()));
  EXPECT_TRUE(cameras().words().contains("live"));
  EXPECT_FALSE(treat_->canAlign());
  treat_->align(false);  // never with an old capture
  EXPECT_TRUE(refused_.contains("take the picture"));
  cameras().takePlain();  // refused: the image with dots comes first
  EXPECT_FALSE(cameras().capture());
  ASSERT_NO_FATAL_FAILURE(guide());
  ASSERT_TRUE(aligned_with_ && aligned_with_->capture);
  EXPECT_LT(aligned_with_->capture->pattern.captured.s, aligned_with_->capture->plain.captured.s);
  EXPECT_TRUE(fixtures::waitFor([&] { return bool(treat_->state()->camera_T_mri); }));
  *unplugged_ = true;
  ASSERT_TRUE(fixtures::waitFor([&] { return !treat_->state()->failure.empty(); }));
  EXPECT_FALSE(treat_->state()->camera_T_mri);  // no old pose remains
  treat_->end();
  EXPECT_EQ(*open_, 0);
}

TEST_F(CamerasTest, ACameraThatHangsWhileGuidingDoesNotHoldUpTheWindow) {
  openCameras();
  ASSERT_NO_FATAL_FAILURE(guide());
  *hung_ = true;
  const Rescue rescue(hung_);
  treat_->end();
  EXPECT_TRUE(*hung_);  // the window continued before the camera did
  EXPECT_FALSE(treat_->isRunning());
  *hung_ = false;
  EXPECT_TRUE(fixtures::waitFor([&] { return *open_ == 0; }));
}

TEST_F(CamerasTest, AnUnpluggedCameraIsSaidAndNothingIsTakenFromIt) {
  openCameras();
  *unplugged_ = true;
  ASSERT_TRUE(fixtures::waitFor([&] { return !cameras().isWell(); }));
  EXPECT_TRUE(cameras().words().contains("check the cable"));
  cameras().takeDots();
  EXPECT_FALSE(cameras().hasDots());
  EXPECT_TRUE(refused_.contains("no fresh picture"));
}

TEST_F(CamerasTest, ACameraThatHangsDoesNotHoldUpTheWindow) {
  openCameras();
  *hung_ = true;
  const Rescue rescue(hung_);
  cameras().show(capture::Recording{});
  EXPECT_TRUE(*hung_);  // the window continued before the camera did
  EXPECT_FALSE(cameras().hasPictures());
  *hung_ = false;
  EXPECT_TRUE(fixtures::waitFor([&] { return *open_ == 0; }));
}

TEST_F(CamerasTest, ClosingTheCamerasForgetsTheirPicturesAndTheAlignment) {
  ASSERT_NO_FATAL_FAILURE(align());
  cameras().closeCameras();
  EXPECT_FALSE(treat_->isAligned());
  EXPECT_FALSE(treat_->hasRecording());
  EXPECT_FALSE(treat_->canAlign());
  EXPECT_FALSE(treat_->canGoOn());
  treat_->start();
  settle();
  EXPECT_FALSE(treat_->isRunning());
  openCameras();
  EXPECT_FALSE(treat_->canAlign()) << "without a new picture";
}

TEST_F(CamerasTest, ASessionThatTakesTheCamerasOverKeepsTheAlignment) {
  openCameras();
  ASSERT_NO_FATAL_FAILURE(guide());
  EXPECT_TRUE(treat_->isAligned());
  treat_->end();
  ASSERT_TRUE(fixtures::waitFor([&] { return *open_ == 0; }));
  EXPECT_TRUE(treat_->isAligned());
  treat_->start();
  settle();
  EXPECT_TRUE(treat_->isRunning());
}

TEST_F(CamerasTest, AnUnpluggedCameraKeepsTheAlignmentForItsReturn) {
  ASSERT_NO_FATAL_FAILURE(align());
  const auto both = plugged_in_;
  plugged_in_ = {both[1]};
  cameras().refreshDevices();
  ASSERT_TRUE(cameras().left().isEmpty());
  EXPECT_TRUE(treat_->isAligned());
  plugged_in_ = both;
  cameras().refreshDevices();
  cameras().choose(kLeft, kRight);
  treat_->start();
  settle();
  EXPECT_TRUE(treat_->isRunning());
}

TEST_F(CamerasTest, AnotherCaseIsNeverAlignedWithThePicturesOfTheLast) {
  ASSERT_NO_FATAL_FAILURE(align());
  const testing::TemporaryFolder other;
  const auto case_folder = fixtures::writeBallCase(other.path());
  casefile::signOff(casefile::CaseStore::open(case_folder), {"XY", "", true});
  TaskMonitor monitor;
  model_.open(loadCase(case_folder, monitor));
  EXPECT_TRUE(cameras().isLive()) << "the cameras stay open";
  EXPECT_FALSE(cameras().hasDots());
  EXPECT_FALSE(cameras().capture());
  EXPECT_FALSE(treat_->isAligned());
  EXPECT_FALSE(treat_->canAlign());
  treat_->align(false);
  EXPECT_TRUE(refused_.contains("take the picture")) << refused_.toStdString();
  ASSERT_NO_FATAL_FAILURE(takeBoth());
}

}  // namespace
}  // namespace facenav::ui
