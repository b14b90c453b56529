// The picture for an alignment without a projector, in the window's step 1: automatic capture when the coil's
// marker rests beside the face.

#include <gtest/gtest.h>

#include <QPushButton>

#include "facenav/scene/display.h"
#include "shell/scroll_column.h"
#include "support/setup_room.h"
#include "treat/cameras_panel.h"
#include "treat/treat_presenter.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;
using facenav::testing::RoomShows;
using facenav::testing::SetupRoom;

class MarkedPicture : public ::testing::Test {
 protected:
  MarkedPicture() {
    cameras::writeRig(rig_, folder_.path() / "stereo.yml");
    services_.listCameras = [](capture::Search) {
      std::vector<capture::FoundCamera> found(2);
      found[0].identity = {"v4l2", "/dev/video0", "Webcam", "A", "1-0"};
      found[1].identity = {"v4l2", "/dev/video2", "Webcam", "B", "1-2"};
      return found;
    };
    services_.openCameras = [this](const cameras::StereoRig&, const std::string&, const std::string&) {
      return std::make_unique<facenav::testing::SetupRoomSource>(room_, rig_);
    };
    services_.makeSetupMethods = [] { return facenav::testing::setupMethods(); };
    services_.align = [this](const casefile::CaseStore&, const capture::Recording& recording,
                             const HeadKnown& known, TaskMonitor&) -> steps::AlignmentOutcome {
      aligned_ = recording;
      coil_ = known.coil ? known.coil->name : "none";
      throw Error("not aligned: enough for this test");
    };
    QObject::connect(&treat_, &TreatPresenter::refused, [this](const QString& words) { refused_ = words; });
    QObject::connect(&tasks_, &TaskRunner::failed, [this](const QString& words) { refused_ = words; });
    QObject::connect(&tasks_, &TaskRunner::progressed,
                     [this](const QString& step, double) { progress_ = step; });
    TaskMonitor monitor;
    model_.open(loadCase(plannedCase(folder_.path(), true), monitor));
    treat_.cameras().setRigFile(QString::fromStdString((folder_.path() / "stereo.yml").string()));
    treat_.cameras().refreshDevices();
  }
  void open() {
    const auto& devices = treat_.cameras().devices();
    ASSERT_EQ(devices.size(), 2u);
    treat_.cameras().choose(QString::fromStdString(capture::stableName(devices[0].identity)),
                            QString::fromStdString(capture::stableName(devices[1].identity)));
    ASSERT_TRUE(treat_.cameras().canOpen());
    treat_.cameras().open();
    ASSERT_TRUE(fixtures::waitFor([&] { return treat_.cameras().isWell() && !tasks_.isRunning(); }));
  }

  facenav::testing::TemporaryFolder folder_;
  cameras::StereoRig rig_ = coil_tracking::testing::roomRig();
  std::shared_ptr<SetupRoom> room_ = std::make_shared<SetupRoom>();
  capture::Recording aligned_;
  std::string coil_;
  QString refused_, progress_;
  Services services_ = fakeServices();
  CaseModel model_;
  TaskRunner tasks_;
  TreatPresenter treat_{services_, model_, tasks_};
};

TEST_F(MarkedPicture, IsTakenByItselfAndAligned) {
  ASSERT_NO_FATAL_FAILURE(open());
  EXPECT_TRUE(treat_.cameras().captureWords().contains("beside the face"));
  EXPECT_FALSE(treat_.canAlign());
  treat_.cameras().takeMarked();
  ASSERT_TRUE(fixtures::waitFor([&] { return progress_.contains("hold the coil beside the face"); }));
  EXPECT_FALSE(treat_.cameras().capture());
  room_->shows = RoomShows::marker;
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.cameras().capture().has_value(); }));
  ASSERT_TRUE(fixtures::waitFor([&] { return !tasks_.isRunning(); }));
  ASSERT_TRUE(treat_.canAlign());
  treat_.align(false);
  ASSERT_TRUE(fixtures::waitFor([&] { return !tasks_.isRunning(); }));
  ASSERT_TRUE(aligned_.capture);
  EXPECT_EQ(aligned_.capture->pattern.left.data, aligned_.capture->plain.left.data) << "no dots";
  EXPECT_EQ(coil_, coil_tracking::defaultCoil().name);
}

TEST_F(MarkedPicture, ItsButtonComesIntoViewInALowWindowWhenTheCamerasAreOpen) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  auto* panel = new CamerasPanel(treat_, nullptr);
  ScrollColumn column(panel, 600);
  column.resize(700, 300);
  column.show();
  QApplication::processEvents();
  QPushButton* take = nullptr;
  for (auto* button : panel->findChildren<QPushButton*>())
    if (button->text() == "Take the picture") take = button;
  ASSERT_TRUE(take);
  EXPECT_TRUE(take->visibleRegion().isEmpty()) << "the devices come first";
  ASSERT_NO_FATAL_FAILURE(open());
  EXPECT_TRUE(fixtures::waitFor([&] { return take->visibleRegion().boundingRect() == take->rect(); }));
}

TEST_F(MarkedPicture, CanBeGivenUp) {
  ASSERT_NO_FATAL_FAILURE(open());
  treat_.cameras().takeMarked();
  ASSERT_TRUE(fixtures::waitFor([&] { return !progress_.isEmpty(); }));
  tasks_.cancel();
  ASSERT_TRUE(fixtures::waitFor([&] { return !tasks_.isRunning(); }));
  EXPECT_FALSE(treat_.cameras().capture());
  EXPECT_FALSE(treat_.canAlign());
}

TEST_F(MarkedPicture, NeedsLiveCameras) {
  treat_.cameras().takeMarked();
  EXPECT_TRUE(refused_.contains("nothing was taken"));
}

}  // namespace
}  // namespace facenav::ui
