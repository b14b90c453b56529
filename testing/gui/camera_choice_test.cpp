// Which cameras and which calibration are chosen: said with what to do, remembered, and never exchanged
// unnoticed.

#include "cameras_fixtures.h"

namespace facenav::ui {
namespace {

using namespace cameras_fixtures;

class CameraChoice : public CamerasTest {
 protected:
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
};

TEST_F(CameraChoice, WithoutACameraItSaysSoAndWhatToDo) {
  plugged_in_.clear();
  cameras().refreshDevices();
  EXPECT_TRUE(cameras().words().contains("no camera found"));
  EXPECT_FALSE(cameras().canOpen());
  plugged_in_ = {webcam("0", "A")};
  cameras().refreshDevices();
  EXPECT_TRUE(cameras().words().contains("one camera only"));
}

TEST_F(CameraChoice, TwoEqualCamerasWithoutSerialNumbersAreToldApartByTheirPorts) {
  plugged_in_ = {webcam("0", ""), webcam("2", "")};
  cameras().refreshDevices();
  EXPECT_EQ(cameras().left(), "v4l2:Webcam@1-0");
  EXPECT_EQ(cameras().right(), "v4l2:Webcam@1-2");
  EXPECT_TRUE(cameras().deviceWords().contains("two equal cameras without serial numbers"));
  cameras().setRigFile(QString::fromStdString((folder_.path() / "stereo.yml").string()));
  EXPECT_TRUE(cameras().words().contains("ready to be opened"));
  EXPECT_TRUE(cameras().words().contains("port"));
}

TEST_F(CameraChoice, ACameraInUseIsSaidWithWhatToDo) {
  plugged_in_[1].use = capture::FoundCamera::Use::in_use;
  plugged_in_[1].user = "cheese (process 4711)";
  cameras().refreshDevices();
  EXPECT_TRUE(cameras().words().contains("in use by cheese (process 4711): close that program"));
}

TEST_F(CameraChoice, NetworkCamerasAreLookedForOnDemandAndStayChosen) {
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

TEST_F(CameraChoice, ANamedRigBringsItsCamerasSettingsAndCalibration) {
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

TEST_F(CameraChoice, ACalibrationThatCannotBeReadIsNamedAndOpensNothing) {
  cameras().choose(kLeft, kRight);
  cameras().setRigFile(QString::fromStdString((folder_.path() / "missing.yml").string()));
  EXPECT_FALSE(cameras().isRigGood());
  EXPECT_TRUE(cameras().rigWords().contains("missing.yml"));
  EXPECT_FALSE(cameras().canOpen());
}

TEST_F(CameraChoice, TheChoiceComesBackAfterARestart) {
  openCameras();
  cameras().swapSides();
  CamerasPresenter again(services_, tasks_);
  EXPECT_EQ(again.left(), kRight);
  EXPECT_EQ(again.right(), kLeft);
  EXPECT_TRUE(again.isRigGood());
}

TEST_F(CameraChoice, WithOtherCamerasChosenSinceNothingIsAlignedOrGuided) {
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

TEST_F(CameraChoice, WithAnotherCalibrationChosenSinceNothingIsAlignedOrGuided) {
  ASSERT_NO_FATAL_FAILURE(align());
  auto other = fakes::rig();
  other.left.k(0, 0) += 1;
  cameras::writeRig(other, folder_.path() / "other.yml");
  for (const char* file : {"other.yml", "missing.yml"}) {
    cameras().setRigFile(QString::fromStdString((folder_.path() / file).string()));
    expectRefused();
  }
}

TEST_F(CameraChoice, WhatIsChosenWhileTheCamerasOpenIsNotWhatWasOpened) {
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

}  // namespace
}  // namespace facenav::ui
