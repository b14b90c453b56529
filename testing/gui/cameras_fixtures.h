#pragma once
// Live cameras for tests of Treat: two webcams that a test plugs in, unplugs and lets hang, and a case that
// is signed off.

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

#include "gui_fixtures.h"
#include "treat/treat_presenter.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::ui::cameras_fixtures {

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

inline const QString kLeft = "v4l2:Webcam#A", kRight = "v4l2:Webcam#B";

inline capture::FoundCamera webcam(const std::string& number, const std::string& serial) {
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
                             const HeadKnown&, TaskMonitor&) {
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
  /// Goes from the two images to running trackers.
  void guide() {
    ASSERT_NO_FATAL_FAILURE(takeBoth());
    treat_->align(true);
    ASSERT_TRUE(fixtures::waitFor([&] { return treat_->isRunning(); }));
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

}  // namespace facenav::ui::cameras_fixtures
