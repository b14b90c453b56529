// Live cameras, replaced by a recording with the timing of live cameras.

#include <gtest/gtest.h>

#include <thread>

#include "gui_fixtures.h"
#include "treat/treat_presenter.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::ui {
namespace {

namespace fakes = session::fakes;

/// Source of frames with the current time, ten milliseconds apart, until it is made to fail.
class FakeCameras : public capture::FrameSource {
 public:
  FakeCameras(std::shared_ptr<std::atomic<int>> open, std::shared_ptr<std::atomic<bool>> unplugged,
              std::shared_ptr<std::atomic<bool>> hung)
      : open_(std::move(open)), unplugged_(std::move(unplugged)), hung_(std::move(hung)) {
    if (++*open_ > 1) throw Error("camera cannot be opened", "camera 4", "is it plugged in and free?");
  }
  ~FakeCameras() override { --*open_; }
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    do {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    } while (*hung_);
    if (*unplugged_) throw Error("camera gives no image", "camera 4", "check the cable");
    return fakes::frame(number_++, Timestamp::now().s);
  }

 private:
  cameras::StereoRig rig_ = fakes::rig();
  std::shared_ptr<std::atomic<int>> open_;
  std::shared_ptr<std::atomic<bool>> unplugged_, hung_;
  std::int64_t number_ = 0;
};

const QString kLeft = "v4l2:Webcam#A", kRight = "v4l2:Webcam#B";

capture::FoundCamera webcam(const std::string& number, const std::string& serial) {
  capture::FoundCamera camera;
  camera.identity = {"v4l2", "/dev/video" + number, "Webcam", serial, "1-" + number};
  return camera;
}

class CamerasTest : public ::testing::Test {
 protected:
  CamerasTest() {
    services_.listCameras = [this](capture::Search search) {
      auto all = plugged_in_;
      if (search == capture::Search::everywhere)
        all.insert(all.end(), on_network_.begin(), on_network_.end());
      return all;
    };
    services_.openCameras = [this](const cameras::StereoRig&, const std::string& left,
                                   const std::string& right) {
      opened_ = {left, right};
      return std::make_unique<FakeCameras>(open_, unplugged_, hung_);
    };
    services_.align = [this](const casefile::CaseStore&, const capture::Recording& recording,
                             const coil_tracking::CoilModel*, TaskMonitor&) {
      aligned_with_ = recording;
      steps::AlignmentOutcome outcome;
      outcome.result.camera_T_mri = fakes::cameraAtReference();
      outcome.reference.frame = *fakes::frame(0, 0);
      return outcome;
    };
    services_.makeNavigator = [](const session::NavigatorSetup& setup) {
      return std::make_unique<session::Navigator>(
          setup, std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
          std::make_unique<fakes::Coil>(
              RigidTransform<Camera, Marker>(Eigen::Quaterniond::Identity(), {20, -60, 550})));
    };
    treat_ = std::make_unique<TreatPresenter>(services_, model_, tasks_);
    QObject::connect(treat_.get(), &TreatPresenter::refused, [this](const QString& w) { refused_ = w; });
    cameras::writeRig(fakes::rig(), folder_.path() / "stereo.yml");
    const auto case_folder = fixtures::writeBallCase(folder_.path());
    casefile::signOff(casefile::CaseStore::open(case_folder), {"XY", "", true});
    TaskMonitor monitor;
    model_.open(loadCase(case_folder, monitor));
  }
  void takeBoth() {
    cameras().takeDots();
    const auto with_dots = cameras().picture()->number;
    ASSERT_TRUE(fixtures::waitFor([&] { return cameras().picture()->number > with_dots; }));
    cameras().takePlain();
    ASSERT_TRUE(treat_->canAlign());
  }
  /// Opens the cameras, and aligns with them.
  void align() {
    openCameras();
    ASSERT_NO_FATAL_FAILURE(takeBoth());
    treat_->align(false);
    settle();
    ASSERT_TRUE(treat_->isAligned());
  }
  /// Expects that nothing starts, and that the window shows what to do.
  void expectRefused() {
    EXPECT_FALSE(treat_->canAlign());
    EXPECT_FALSE(treat_->canGoOn());
    refused_.clear();
    treat_->start();
    settle();
    EXPECT_FALSE(treat_->isRunning());
    EXPECT_TRUE(refused_.contains("chosen now: open the cameras again")) << refused_.toStdString();
    refused_.clear();
    treat_->align(false);
    EXPECT_TRUE(refused_.contains("chosen now: open the cameras again")) << refused_.toStdString();
  }
  /// Goes from the two images to running trackers.
  void guide() {
    ASSERT_NO_FATAL_FAILURE(takeBoth());
    treat_->align(true);
    settle();
    settle();
    ASSERT_TRUE(treat_->isRunning());
  }
  void openCameras() {
    cameras().setRigFile(QString::fromStdString((folder_.path() / "stereo.yml").string()));
    cameras().refreshDevices();
    cameras().choose(kLeft, kRight);
    ASSERT_TRUE(cameras().canOpen());
    cameras().open();
    ASSERT_TRUE(fixtures::waitFor([&] { return cameras().isWell(); }));
  }
  void settle() {
    fixtures::waitFor([&] { return !tasks_.isRunning(); });
  }
  CamerasPresenter& cameras() { return treat_->cameras(); }

  testing::TemporaryFolder folder_;
  Services services_;
  CaseModel model_;
  TaskRunner tasks_;
  std::vector<capture::FoundCamera> plugged_in_{webcam("2", "A"), webcam("4", "B")}, on_network_;
  std::shared_ptr<std::atomic<int>> open_ = std::make_shared<std::atomic<int>>(0);
  std::shared_ptr<std::atomic<bool>> unplugged_ = std::make_shared<std::atomic<bool>>(false);
  std::shared_ptr<std::atomic<bool>> hung_ = std::make_shared<std::atomic<bool>>(false);
  std::pair<std::string, std::string> opened_;
  std::optional<capture::Recording> aligned_with_;
  QString refused_;
  std::unique_ptr<TreatPresenter> treat_;
};

TEST_F(CamerasTest, WithoutACameraItSaysSoAndWhatToDo) {
  plugged_in_.clear();
  cameras().refreshDevices();
  EXPECT_TRUE(cameras().words().contains("no camera found"));
  EXPECT_FALSE(cameras().canOpen());
  plugged_in_ = {webcam("0", "A")};
  cameras().refreshDevices();
  EXPECT_TRUE(cameras().words().contains("one camera only"));
}

TEST_F(CamerasTest, TwoEqualCamerasWithoutSerialNumbersAreToldApartByTheirPorts) {
  plugged_in_ = {webcam("0", ""), webcam("2", "")};
  cameras().refreshDevices();
  EXPECT_EQ(cameras().left(), "v4l2:Webcam@1-0");
  EXPECT_EQ(cameras().right(), "v4l2:Webcam@1-2");
  EXPECT_TRUE(cameras().deviceWords().contains("two equal cameras without serial numbers"));
  cameras().setRigFile(QString::fromStdString((folder_.path() / "stereo.yml").string()));
  EXPECT_TRUE(cameras().words().contains("ready to be opened"));
  EXPECT_TRUE(cameras().words().contains("port"));
}

TEST_F(CamerasTest, ACameraInUseIsSaidWithWhatToDo) {
  plugged_in_[1].use = capture::FoundCamera::Use::in_use;
  plugged_in_[1].user = "cheese (process 4711)";
  cameras().refreshDevices();
  EXPECT_TRUE(cameras().words().contains("in use by cheese (process 4711): close that program"));
}

TEST_F(CamerasTest, NetworkCamerasAreLookedForOnDemandAndStayChosen) {
  capture::FoundCamera gige;
  gige.identity = {"genicam", "GV01", "Vendor Model", "7", "192.168.1.7"};
  on_network_ = {gige};
  cameras().lookEverywhere();
  settle();
  ASSERT_EQ(cameras().devices().size(), 3u);
  cameras().choose("genicam:Vendor Model#7", kRight);
  cameras().refreshDevices();
  EXPECT_EQ(cameras().devices().size(), 3u);
  EXPECT_EQ(cameras().left(), "genicam:Vendor Model#7");
  on_network_.clear();
  cameras().lookEverywhere();
  settle();
  EXPECT_TRUE(cameras().left().isEmpty());
}

TEST_F(CamerasTest, ANamedRigBringsItsCamerasSettingsAndCalibration) {
  capture::RigEntry entry{"bar", folder_.path(), capture::NamedRig(), ""};
  entry.rig->rig = fakes::rig();
  entry.rig->left = capture::RigCamera{plugged_in_[1].identity, {}};
  entry.rig->right = capture::RigCamera{plugged_in_[0].identity, {}};
  entry.rig->last_check = capture::RigCheckNote{"", "holds", "the calibration holds"};
  services_.listRigs = [&] { return std::vector<capture::RigEntry>{entry}; };
  services_.openRig = [this](const capture::NamedRig& rig, const RigVerifying&) {
    opened_ = {capture::stableName(rig.left->identity), capture::stableName(rig.right->identity)};
    return std::make_unique<FakeCameras>(open_, unplugged_, hung_);
  };
  cameras().chooseRig("bar");
  EXPECT_EQ(cameras().left(), kRight);
  EXPECT_TRUE(cameras().rigWords().contains("last check: the calibration holds"));
  plugged_in_.clear();
  cameras().refreshDevices();
  EXPECT_EQ(cameras().rigName(), "bar");  // chosen again after it is plugged in
  cameras().open();
  ASSERT_TRUE(fixtures::waitFor([&] { return cameras().isWell(); }));
  EXPECT_EQ(opened_, std::make_pair(kRight.toStdString(), kLeft.toStdString()));
  EXPECT_EQ(CamerasPresenter(services_, tasks_).rigName(), "bar");
  cameras().swapSides();
  EXPECT_TRUE(cameras().rigName().isEmpty());
}

TEST_F(CamerasTest, ACalibrationThatCannotBeReadIsNamedAndOpensNothing) {
  cameras().choose(kLeft, kRight);
  cameras().setRigFile(QString::fromStdString((folder_.path() / "missing.yml").string()));
  EXPECT_FALSE(cameras().isRigGood());
  EXPECT_TRUE(cameras().rigWords().contains("missing.yml"));
  EXPECT_FALSE(cameras().canOpen());
}

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
  std::thread rescue([hung = hung_] {  // frees a window that would wait for ever
    std::this_thread::sleep_for(std::chrono::seconds(5));
    *hung = false;
  });
  treat_->end();
  EXPECT_TRUE(*hung_);  // the window continued before the camera did
  EXPECT_FALSE(treat_->isRunning());
  *hung_ = false;
  rescue.join();
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
  std::thread rescue([hung = hung_] {  // frees a window that would wait for ever
    std::this_thread::sleep_for(std::chrono::seconds(3));
    *hung = false;
  });
  cameras().show(capture::Recording{});
  EXPECT_TRUE(*hung_);  // the window continued before the camera did
  EXPECT_FALSE(cameras().hasPictures());
  *hung_ = false;
  rescue.join();
  EXPECT_TRUE(fixtures::waitFor([&] { return *open_ == 0; }));
}

TEST_F(CamerasTest, TheChoiceComesBackAfterARestart) {
  openCameras();
  cameras().swapSides();
  CamerasPresenter again(services_, tasks_);
  EXPECT_EQ(again.left(), kRight);
  EXPECT_EQ(again.right(), kLeft);
  EXPECT_TRUE(again.isRigGood());
}

TEST_F(CamerasTest, WithOtherCamerasChosenSinceNothingIsAlignedOrGuided) {
  ASSERT_NO_FATAL_FAILURE(align());
  cameras().swapSides();
  EXPECT_TRUE(cameras().words().contains("open the cameras again"));
  expectRefused();
  cameras().swapSides();  // exchanged back to the opened choice
  EXPECT_TRUE(treat_->canAlign());
  EXPECT_TRUE(treat_->canGoOn());
  treat_->start();
  settle();
  EXPECT_TRUE(treat_->isRunning());
}

TEST_F(CamerasTest, WithAnotherCalibrationChosenSinceNothingIsAlignedOrGuided) {
  ASSERT_NO_FATAL_FAILURE(align());
  auto other = fakes::rig();
  other.left.k(0, 0) += 1;
  cameras::writeRig(other, folder_.path() / "other.yml");
  for (const char* file : {"other.yml", "missing.yml"}) {
    cameras().setRigFile(QString::fromStdString((folder_.path() / file).string()));
    expectRefused();
  }
}

TEST_F(CamerasTest, WhatIsChosenWhileTheCamerasOpenIsNotWhatWasOpened) {
  cameras().setRigFile(QString::fromStdString((folder_.path() / "stereo.yml").string()));
  cameras().refreshDevices();
  cameras().choose(kLeft, kRight);
  cameras().open();
  ASSERT_TRUE(tasks_.isRunning());
  cameras().setRigFile(QString::fromStdString((folder_.path() / "missing.yml").string()));
  cameras().swapSides();
  ASSERT_TRUE(fixtures::waitFor([&] { return cameras().isWell(); }));
  ASSERT_TRUE(treat_->rig());
  EXPECT_TRUE(cameras::isSameCalibration(*treat_->rig(), cameras::readRig(folder_.path() / "stereo.yml")));
  EXPECT_TRUE(treat_->recordingWords().contains(kLeft + " and " + kRight));
  cameras().takeDots();
  EXPECT_FALSE(treat_->canAlign());
  treat_->align(false);
  EXPECT_TRUE(refused_.contains("open the cameras again"));
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
