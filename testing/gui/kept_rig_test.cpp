// A kept rig in the window: it is verified when its cameras open, and one that has moved is used neither for
// alignment nor for guidance. And the first page of the set-up with every kind of connected cameras.
// FACENAV_GUI_PICTURES=DIR keeps images.

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <thread>

#include "facenav/scene/display.h"
#include "home/fitted_words.h"
#include "setup/setup_window.h"
#include "shell/appearance.h"
#include "shell/main_window.h"
#include "support/setup_room.h"
#include "support/v4l2_tree.h"
#include "treat/cameras_panel.h"
#include "treat/treat_workspace.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;
using health::RigState;

/// Live pictures that differ from each other, a hundred a second.
class LivePlain : public capture::FrameSource {
 public:
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return fakes::frame(number_++, Timestamp::now().s);
  }

 private:
  cameras::StereoRig rig_ = fakes::rig();
  std::int64_t number_ = 0;
};

capture::FoundCamera keptCamera(const std::string& number, const std::string& serial) {
  capture::FoundCamera camera;
  camera.identity = {"v4l2", "/dev/video" + number, "Webcam", serial, "1-" + number};
  return camera;
}

void keepPicture(QWidget& window, const QString& name) {
  fixtures::layOut();
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
    window.grab().save(QString("%1/%2.png").arg(pictures, name));
}

/// Waits until the window's sentence contains `words`.
bool showsSentence(const SetupWindow& window, const char* words) {
  const auto* sentence = window.findChild<FittedWords*>("setup_sentence");
  return fixtures::waitFor([&] { return sentence->words().contains(words); });
}

/// The button whose tip contains `tip`.
QPushButton* buttonOf(const QWidget& panel, const QString& tip) {
  for (auto* button : panel.findChildren<QPushButton*>())
    if (button->toolTip().contains(tip)) return button;
  return nullptr;
}

QPushButton* stepOf(const QWidget& window, const QString& words) {
  for (auto* button : window.findChildren<QPushButton*>())
    if (button->text().startsWith(words)) return button;
  return nullptr;
}

class KeptRig : public ::testing::Test {
 protected:
  KeptRig() {
    entry_.name = "room 1";
    entry_.folder = folder_.path() / "rig";
    std::filesystem::create_directories(entry_.folder);
    cameras::writeRig(fakes::rig(), entry_.folder / "stereo.yml");
    entry_.rig = capture::NamedRig();
    entry_.rig->name = entry_.name;
    entry_.rig->rig = fakes::rig();
    entry_.rig->left = capture::RigCamera{keptCamera("0", "A").identity, {}};
    entry_.rig->right = capture::RigCamera{keptCamera("2", "B").identity, {}};
    services_.listRigs = [this] { return std::vector<capture::RigEntry>{entry_}; };
    services_.listCameras = [](capture::Search) {
      return std::vector<capture::FoundCamera>{keptCamera("0", "A"), keptCamera("2", "B")};
    };
    services_.openCameras = [](const cameras::StereoRig&, const std::string&, const std::string&) {
      return std::make_unique<LivePlain>();
    };
    services_.openRig = [this](const capture::NamedRig& rig, const RigVerifying& verifying) {
      verifying_ = verifying;
      steps::RigStartCheck check(rig, {});
      return std::make_unique<steps::VerifiedCameras>(std::make_unique<LivePlain>(), std::move(check),
                                                      "repair them: Check and repair the cameras",
                                                      verifying.told);
    };
  }
  /// Sets the result of the check.
  void tell(RigState state, const std::string& geometry) {
    steps::RigStart found;
    found.state = state;
    found.geometry = geometry;
    verifying_.told(found);
  }
  void noteFault() {
    entry_.rig->last_check = capture::RigCheckNote{
        "2026-11-24T16:20:00Z", "moved",
        "the cameras have moved against each other since their calibration (the right one turned by about "
        "0.40 "
        "deg, marker measured 61.30 mm instead of 60.00 mm, rows 0.31 px apart): calibrate again"};
  }
  void open(TreatPresenter& treat) {
    treat.cameras().chooseRig("room 1");
    treat.cameras().refreshDevices();
    ASSERT_TRUE(treat.cameras().canOpen());
    treat.cameras().open();
    ASSERT_TRUE(fixtures::waitFor([&] { return treat.cameras().isWell(); }));
  }

  testing::TemporaryFolder folder_;
  capture::RigEntry entry_;
  RigVerifying verifying_;
  Services services_ = fakeServices();
};

class KeptRigTreat : public KeptRig {
 protected:
  KeptRigTreat() {
    QObject::connect(&treat_, &TreatPresenter::refused, [this](const QString& words) { refused_ = words; });
    const auto case_folder = plannedCase(folder_.path(), true);
    TaskMonitor monitor;
    model_.open(loadCase(case_folder, monitor));
  }
  void takeBoth() {
    treat_.cameras().takeDots();
    const auto with_dots = treat_.cameras().picture()->number;
    ASSERT_TRUE(fixtures::waitFor([&] { return treat_.cameras().picture()->number > with_dots; }));
    treat_.cameras().takePlain();
  }
  void settle() {
    fixtures::waitFor([&] { return !tasks_.isRunning(); });
  }
  CaseModel model_;
  TaskRunner tasks_;
  TreatPresenter treat_{services_, model_, tasks_};
  QString refused_;
};

TEST_F(KeptRigTreat, IsVerifiedWhenItsCamerasOpenAndSaidInOneLine) {
  ASSERT_NO_FATAL_FAILURE(open(treat_));
  EXPECT_TRUE(treat_.cameras().words().contains("compared with what was kept"));
  EXPECT_EQ(verifying_.coil.name, coil_tracking::defaultCoil().name) << "the coil in use";
  tell(RigState::holds, "the calibration holds: the coil's marker measures 60.02 mm, 60.00 mm true");
  EXPECT_TRUE(treat_.cameras().words().contains("as kept; the calibration holds: the coil's marker"));
  EXPECT_TRUE(treat_.rigFault().isEmpty());
  takeBoth();
  EXPECT_TRUE(treat_.canAlign());
}

TEST_F(KeptRigTreat, UnclearBlocksNothing) {
  ASSERT_NO_FATAL_FAILURE(open(treat_));
  tell(RigState::unclear, "");
  EXPECT_TRUE(treat_.cameras().words().contains("not clear yet"));
  takeBoth();
  EXPECT_TRUE(treat_.canAlign());
}

TEST_F(KeptRigTreat, WithCamerasThatMovedNothingIsAlignedOrGuided) {
  ASSERT_NO_FATAL_FAILURE(open(treat_));
  takeBoth();
  ASSERT_TRUE(treat_.canAlign());
  treat_.align(false);
  settle();
  ASSERT_TRUE(treat_.isAligned());
  tell(RigState::moved, "the cameras have moved against each other since their calibration");
  EXPECT_TRUE(treat_.rigFault().contains("moved against each other"));
  EXPECT_FALSE(treat_.canAlign());
  EXPECT_FALSE(treat_.canGoOn());
  treat_.align(false);
  EXPECT_TRUE(refused_.contains("moved against each other")) << refused_.toStdString();
  refused_.clear();
  treat_.start();
  settle();
  EXPECT_FALSE(treat_.isRunning());
  EXPECT_TRUE(refused_.contains("moved against each other")) << refused_.toStdString();
  treat_.cameras().closeCameras();  // for the repair
  EXPECT_TRUE(treat_.rigFault().isEmpty());
  EXPECT_FALSE(treat_.isAligned()) << "of the old calibration";
  EXPECT_FALSE(treat_.hasRecording());
}

TEST_F(KeptRigTreat, CalibratedAnewItIsNotGuidedWithTheOldAlignment) {
  ASSERT_NO_FATAL_FAILURE(open(treat_));
  takeBoth();
  treat_.align(false);
  settle();
  ASSERT_TRUE(treat_.isAligned());
  entry_.rig->rig.left.row_time_s = 20e-6;  // as a session measured it
  treat_.cameras().readAgain();
  EXPECT_TRUE(treat_.canAlign());
  entry_.rig->rig.right.k(0, 0) += 1;
  treat_.start();
  settle();
  EXPECT_FALSE(treat_.isRunning());
  EXPECT_TRUE(refused_.contains("chosen now: open the cameras again")) << refused_.toStdString();
  EXPECT_FALSE(treat_.canAlign());
}

/// A fault of an earlier day is in force from the first picture on.
TEST_F(KeptRigTreat, AFaultThatWasNotRepairedIsInForceAtOnce) {
  noteFault();
  ASSERT_NO_FATAL_FAILURE(open(treat_));
  EXPECT_TRUE(fixtures::waitFor([&] { return treat_.rigFault().contains("not repaired"); }));
  EXPECT_TRUE(treat_.rigFault().contains("Check and repair the cameras"));
  takeBoth();
  EXPECT_FALSE(treat_.canAlign());
}

/// A fault found when the session opens the cameras anew blanks its poses.
TEST_F(KeptRigTreat, ASessionWithCamerasThatMovedShowsNoPose) {
  ASSERT_NO_FATAL_FAILURE(open(treat_));
  takeBoth();
  treat_.align(false);
  settle();
  noteFault();  // read at the start
  treat_.start();
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.isRunning(); }));
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.state()->frame > 5; }));
  for (int i = 0; i < 20; ++i) {
    const auto state = treat_.state();
    EXPECT_FALSE(state->camera_T_mri);
    EXPECT_FALSE(state->camera_T_coil);
    EXPECT_FALSE(state->guidance.values);
    QTest::qWait(20);
  }
  EXPECT_TRUE(treat_.rigFault().contains("not repaired"));
}

TEST_F(KeptRig, TheWindowOffersTheRepairAtEverySize) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto case_folder = plannedCase(folder_.path(), true);
  TaskRunner tasks;
  CamerasPresenter(services_, tasks).chooseRig("room 1");  // remembered
  for (const double scale : {1.0, 2.0}) {
    applyAppearance(*qApp, scale);
    entry_.rig->last_check.reset();
    MainWindow window(services_);
    window.resize(1366, 768);
    window.show();
    window.openCase(QString::fromStdString(case_folder.string()));
    ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().mayTreat(); }));
    window.setWorkspace(Workspace::treat);
    auto* panel = window.findChild<CamerasPanel*>();
    ASSERT_TRUE(fixtures::waitFor([&] { return buttonOf(*panel, "live pictures")->isEnabled(); }));
    buttonOf(*panel, "live pictures")->click();
    ASSERT_TRUE(fixtures::waitFor([&] { return bool(verifying_.told); }));
    const auto takeAll = [&](const QString& name, const char* words) {
      EXPECT_TRUE(fixtures::waitFor([&] {
        const auto labels = panel->findChildren<QLabel*>("verdict");
        return std::any_of(labels.begin(), labels.end(),
                           [&](const auto* label) { return label->text().contains(words); });
      })) << words;
      for (const QSize size :
           scale > 1 ? std::vector<QSize>{{1920, 1080}} : std::vector<QSize>{{1366, 768}, {1920, 1080}}) {
        window.resize(size);
        keepPicture(window,
                    QString("kept_%1_%2%3").arg(name).arg(size.width()).arg(scale > 1 ? "_double" : ""));
        EXPECT_EQ(window.size(), size);
      }
    };
    tell(RigState::holds, "the calibration holds: the coil's marker measures 60.02 mm, 60.00 mm true");
    takeAll("holds", "the calibration holds");
    tell(RigState::moved,
         "the cameras have moved against each other since their calibration (the right one turned by about "
         "0.40 "
         "deg, marker measured 61.30 mm instead of 60.00 mm, rows 0.31 px apart): calibrate again");
    takeAll("moved", "have moved against each other");
    const auto* repair = buttonOf(*panel, "four steps");
    EXPECT_TRUE(repair->isEnabled());
    EXPECT_TRUE(repair->text().contains("repair")) << repair->text().toStdString();
    EXPECT_EQ(repair->objectName(), "primary");
    const auto* step = stepOf(window, "1 Cameras");
    ASSERT_TRUE(step);
    EXPECT_TRUE(fixtures::waitFor([&] { return step->text().contains(QChar(0x2715)); }))
        << step->text().toStdString();
    verifying_ = {};
  }
  applyAppearance(*qApp, 1.0);
}

TEST_F(KeptRig, TheSetUpWaitsForATaskThatMayHoldTheCameras) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  std::atomic<bool> may_open{false};
  services_.makeSetupMethods = [] { return testing::setupMethods(); };
  services_.openRig = [&](const capture::NamedRig&, const RigVerifying&) {
    while (!may_open) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return std::make_unique<LivePlain>();
  };
  TaskRunner tasks;
  CamerasPresenter(services_, tasks).chooseRig("room 1");  // remembered
  MainWindow window(services_);
  window.show();
  window.setWorkspace(Workspace::treat);
  auto* panel = window.findChild<CamerasPanel*>();
  ASSERT_TRUE(fixtures::waitFor([&] { return buttonOf(*panel, "live pictures")->isEnabled(); }));
  buttonOf(*panel, "live pictures")->click();
  ASSERT_TRUE(window.tasks().isRunning());
  EXPECT_TRUE(fixtures::waitFor([&] { return !buttonOf(*panel, "four steps")->isEnabled(); }));
  window.setUpCameras();
  EXPECT_FALSE(window.findChild<SetupWindow*>());
  EXPECT_TRUE(stepOf(*window.findChild<QWidget*>("taskbar"), "Cancel")->isVisible())
      << "the task can still be cancelled";
  may_open = true;
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }));
  window.setUpCameras();
  EXPECT_TRUE(window.findChild<SetupWindow*>());
}

struct ConnectedCase {
  const char* name;
  std::function<void(testing::V4l2Tree&)> connect;
  const char* words;  // in the sentence
  bool can_open;
};

TEST_F(KeptRig, TheSetUpSaysWhatToDoAboutTheConnectedCameras) {
  const ConnectedCase cases[] = {
      {"none", [](testing::V4l2Tree&) {}, "no camera found: plug two cameras in and look again", false},
      {"one", [](testing::V4l2Tree& tree) { tree.add("video0", "HD Webcam C920", "1-1", "A1"); },
       "one camera only: two are needed; plug the other in and look again", false},
      {"equal",
       [](testing::V4l2Tree& tree) {
         tree.add("video0", "USB Camera", "1-1", "");
         tree.add("video2", "USB Camera", "1-2", "");
       },
       "only their ports tell them apart; mark cables and ports left and right", true},
      {"in_use",
       [](testing::V4l2Tree& tree) {
         tree.add("video0", "HD Webcam C920", "1-1", "A1");
         tree.add("video2", "HD Webcam C920", "1-2", "B2");
         tree.use("video2", "cheese", "4711");
       },
       "in use by cheese (process 4711): close that program and look again", true},
      {"not_allowed",
       [](testing::V4l2Tree& tree) {
         tree.add("video0", "HD Webcam C920", "1-1", "A1");
         tree.add("video2", "HD Webcam C920", "1-2", "B2");
         tree.kernel().cameras["/dev/video0"]->open_error = EACCES;
       },
       "this user may not open it: ask your administrator", true}};
  services_.openNewCameras = [](const std::string&, const std::string&, int, int) {
    return NewCameras{std::make_unique<LivePlain>(), {}, {}};
  };
  services_.makeSetupMethods = [] { return testing::setupMethods(); };
  for (const auto& each : cases) {
    testing::V4l2Tree tree;
    each.connect(tree);
    services_.listCameras = [&tree](capture::Search) { return tree.list(); };
    for (const double scale : {1.0, 2.0}) {
      applyAppearance(*qApp, scale);
      SetupWindow window(services_);
      auto& setup = window.presenter();
      ASSERT_TRUE(fixtures::waitFor([&] { return setup.sentence().contains(each.words); }))
          << each.name << ": " << setup.sentence().toStdString();
      EXPECT_EQ(setup.sentence().count('\n'), 0);
      EXPECT_TRUE(showsSentence(window, each.words)) << each.name;
      EXPECT_EQ(setup.canOpen(), each.can_open) << each.name;
      if (!scene::hasDisplay()) continue;
      for (const QSize size : {QSize(1366, 768), QSize(1920, 1080)}) {
        window.resize(size);
        window.show();
        keepPicture(
            window,
            QString("first_%1_%2%3").arg(each.name).arg(size.width()).arg(scale > 1 ? "_double" : ""));
        EXPECT_EQ(window.size(), size);
      }
    }
  }
  applyAppearance(*qApp, 1.0);
}

}  // namespace
}  // namespace facenav::ui
