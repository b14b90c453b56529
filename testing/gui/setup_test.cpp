// The set-up of a camera pair: the presenter's steps, and the window at four sizes. FACENAV_GUI_PICTURES=DIR
// keeps images.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QtTest/QTest>
#include <cstdlib>

#include "facenav/capture/stream_logins.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "home/fitted_words.h"
#include "setup/board_screen.h"
#include "setup/latency_screen.h"
#include "setup/setup_window.h"
#include "shell/appearance.h"
#include "support/setup_room.h"
#include "treat/chosen_cameras.h"

namespace facenav::ui {
namespace {

using Step = steps::SetupStep;
using testing::RoomShows;
namespace boards = coil_tracking::testing;

class SetupTest : public ::testing::Test {
 protected:
  SetupTest() {
    services_.listCameras = [](capture::Search) {
      std::vector<capture::FoundCamera> all(2);
      all[0].identity = {"v4l2", "/dev/video0", "Webcam", "A", "1-1"};
      all[1].identity = {"v4l2", "/dev/video2", "Webcam", "B", "1-2"};
      return all;
    };
    services_.openNewCameras = [this](const std::string& left, const std::string& right, int width_px,
                                      int height_px) {
      NewCameras cameras{source(), {}, {}};
      cameras.left.identity = {"v4l2", "/dev/video0", "Webcam", left.substr(left.size() - 1), "1-1"};
      cameras.right.identity = {"v4l2", "/dev/video2", "Webcam", right.substr(right.size() - 1), "1-2"};
      opened_ = QString("%1x%2").arg(width_px).arg(height_px);
      return cameras;
    };
    services_.listRigs = [this] { return rigs_; };
    services_.openRig = [this](const capture::NamedRig&, const RigVerifying&) { return source(); };
    services_.keepRig = [this](const capture::NamedRig& rig, Existing existing) {
      if (!rigs_.empty() && existing == Existing::refuse) throw Error("there is a rig of this name");
      rigs_ = {{rig.name, "/rigs/" + rig.name, rig, ""}};
    };
    services_.noteRig = [this](const std::string& name, const capture::RigCheckNote& note) {
      noted_ = QString::fromStdString(name + ": " + note.state);
    };
    services_.keepLearnt = [this](const std::string&, const steps::CamerasLearnt& learnt) {
      learnt_ = learnt;
    };
    services_.makeSetupMethods = [] { return testing::setupMethods(); };
  }
  std::unique_ptr<capture::FrameSource> source() {
    return std::make_unique<testing::SetupRoomSource>(room_, rig_);
  }
  static bool done(SetupPresenter& setup, Step step) {
    return fixtures::waitFor(
        [&] { return setup.view()->step == step && setup.view()->is_done && setup.view()->frame; }, 120000);
  }
  static bool says(SetupPresenter& setup, const char* words) {
    const bool is_said = fixtures::waitFor([&] { return setup.sentence().contains(words); }, 60000);
    EXPECT_TRUE(is_said) << words << " in: " << setup.sentence().toStdString();
    return is_said;
  }
  QString jigFile(int marker) const {
    auto jig = coil_tracking::defaultCoil();
    jig.name = "jig";
    jig.markers.front().id = marker;
    const auto file = folder_.path() / ("jig" + std::to_string(marker) + ".json");
    coil_tracking::writeCoil(jig, file);
    return QString::fromStdString(file.string());
  }
  /// Goes to a step; before it, the room shows `what`.
  void go(SetupPresenter& setup, RoomShows what, Step step) {
    room_->shows = what;
    setup.go(step);
    ASSERT_TRUE(fixtures::waitFor([&] { return setup.view()->step == step; }));
  }
  void open(SetupPresenter& setup) {
    setup.setBoard(9, 6, 20.0);
    setup.lookForCameras();
    ASSERT_TRUE(fixtures::waitFor([&] { return setup.canOpen(); }));
    setup.chooseSize("640x480");
    setup.open();
    ASSERT_TRUE(fixtures::waitFor([&] { return setup.isOpen() && setup.view()->frame; }));
  }

  testing::TemporaryFolder folder_;
  std::shared_ptr<testing::SetupRoom> room_ = std::make_shared<testing::SetupRoom>();
  cameras::StereoRig rig_ = boards::roomRig();
  std::vector<capture::RigEntry> rigs_;
  QString opened_, noted_;
  steps::CamerasLearnt learnt_;
  Services services_;
};

TEST_F(SetupTest, EndsWithARigUnderAName) {
  TaskRunner tasks;
  SetupPresenter setup(services_, tasks);
  EXPECT_TRUE(setup.sentence().contains("no camera found"));
  ASSERT_NO_FATAL_FAILURE(open(setup));
  EXPECT_EQ(opened_, "640x480");
  EXPECT_EQ(setup.left(), "v4l2:Webcam#A");
  EXPECT_FALSE(setup.canGo(Step::check)) << "not before it is calibrated";
  ASSERT_NO_FATAL_FAILURE(go(setup, RoomShows::held_board, Step::calibrate));
  ASSERT_TRUE(done(setup, Step::calibrate)) << setup.sentence().toStdString();
  EXPECT_FALSE(setup.resultWords().isEmpty());
  QString refused;
  QObject::connect(&setup, &SetupPresenter::refused, [&](const QString& words) { refused = words; });
  EXPECT_FALSE(setup.keep(false));
  EXPECT_TRUE(refused.contains("once its check holds")) << refused.toStdString();
  ASSERT_NO_FATAL_FAILURE(go(setup, RoomShows::new_place, Step::check));
  ASSERT_TRUE(done(setup, Step::check)) << setup.sentence().toStdString();
  setup.setName("room 4");
  ASSERT_TRUE(setup.keep(false));
  ASSERT_EQ(rigs_.size(), 1u);
  EXPECT_EQ(rigs_[0].name, "room 4");
  EXPECT_EQ(rigs_[0].rig->left->identity.serial, "A");
  EXPECT_EQ(rigs_[0].rig->last_check->state, "holds");
  EXPECT_LT(rigs_[0].rig->uncertainty->point_mm, 1.0);
  EXPECT_TRUE(setup.isNameTaken());
  // On the next day the bar is bumped.
  room_->turned_deg = 0.4;
  setup.openKept("room 4");
  ASSERT_TRUE(fixtures::waitFor([&] { return setup.view()->needs_repair; }, 120000));
  EXPECT_TRUE(setup.sentence().contains("calibrate again")) << setup.sentence().toStdString();
  setup.noteCheckOfKept();
  EXPECT_EQ(noted_, "room 4: moved");
  EXPECT_FALSE(setup.isKept());
  room_->shows = RoomShows::held_board;
  setup.repeatViews();
  ASSERT_TRUE(done(setup, Step::calibrate)) << setup.sentence().toStdString();
  ASSERT_NO_FATAL_FAILURE(go(setup, RoomShows::new_place, Step::check));
  ASSERT_TRUE(done(setup, Step::check)) << setup.sentence().toStdString();
  EXPECT_TRUE(setup.keep(true));
}

TEST_F(SetupTest, AnUnpluggedCameraIsSaidInOneSentence) {
  TaskRunner tasks;
  SetupPresenter setup(services_, tasks);
  ASSERT_NO_FATAL_FAILURE(open(setup));
  room_->is_unplugged = true;
  EXPECT_TRUE(fixtures::waitFor([&] { return setup.sentence().contains("unplugged"); }));
}

TEST_F(SetupTest, WhatIsWrongWithATypedAddressStandsAtItsField) {
  services_.listCameras = [](capture::Search) { return std::vector<capture::FoundCamera>(); };
  services_.openNewCameras = [](const std::string&, const std::string& right, int, int) -> NewCameras {
    throw steps::PairError({capture::CameraFault::missing, "the stream cannot be opened", right, "check it"},
                           false);
  };
  TaskRunner tasks;
  SetupPresenter setup(services_, tasks);
  setup.lookForCameras();
  ASSERT_TRUE(fixtures::waitFor([&] { return !tasks.isRunning(); }));
  EXPECT_TRUE(setup.sentence().contains("or type the address")) << setup.sentence().toStdString();
  setup.choose("/no/such/left.mkv", "rtsp://host/right");
  EXPECT_TRUE(setup.trouble(SetupField::left).contains("there is no such file or folder"));
  EXPECT_EQ(setup.trouble(SetupField::right), "");
  EXPECT_FALSE(setup.canOpen());
  setup.choose("rtsp://host/left", "rtsp://host/left");
  EXPECT_TRUE(setup.trouble(SetupField::right).contains("this is the left camera"));
  setup.choose("rtsp://host/left", "rtsp://host/right");
  setup.chooseSize("1280 by 720");
  EXPECT_TRUE(setup.trouble(SetupField::size).contains("as 1280x720"));
  EXPECT_FALSE(setup.canOpen());
  setup.chooseSize("1456 x 1088");
  EXPECT_EQ(setup.trouble(SetupField::size), "");
  ASSERT_TRUE(setup.canOpen());
  setup.open();
  ASSERT_TRUE(fixtures::waitFor([&] { return !tasks.isRunning(); }));
  EXPECT_TRUE(setup.trouble(SetupField::right).contains("the stream cannot be opened; check it"))
      << setup.trouble(SetupField::right).toStdString();
  EXPECT_EQ(setup.trouble(SetupField::left), "");
  EXPECT_TRUE(setup.canOpen()) << "it may be tried again";
  setup.lookForCameras();
  ASSERT_TRUE(fixtures::waitFor([&] { return !tasks.isRunning(); }));
  EXPECT_EQ(setup.left(), "rtsp://host/left") << "no search finds an address, and none forgets it";
}

TEST_F(SetupTest, APasswordThatWasTypedIsNotShownAgainAndNotKeptInTheSettings) {
  services_.listCameras = [](capture::Search) { return std::vector<capture::FoundCamera>(); };
  TaskRunner tasks;
  SetupPresenter setup(services_, tasks);
  setup.choose("rtsp://doe:secret@host/left", "/no/such:secret@folder");
  EXPECT_EQ(setup.left(), "rtsp://doe@host/left");
  EXPECT_EQ(setup.trouble(SetupField::left), "");
  EXPECT_EQ(capture::StreamLogins().openingAddress(capture::streamIdentity(setup.left().toStdString())),
            "rtsp://doe:secret@host/left");
  ChosenCameras chosen(services_, tasks);
  chosen.choose("rtsp://doe:secret@host/left", "rtsp://doe:secret@host/right");
  EXPECT_EQ(chosen.right(), "rtsp://doe@host/right");
  for (const QString& key : QSettings().allKeys())
    EXPECT_FALSE(QSettings().value(key).toString().contains("secret")) << key.toStdString();
  QSettings().setValue("cameras/left_name", "rtsp://doe:secret@host/left");  // of an earlier version
  EXPECT_EQ(ChosenCameras(services_, tasks).left(), "rtsp://doe@host/left");
}

TEST_F(SetupTest, AnAddressIsTypedInTheWindow) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  services_.listCameras = [](capture::Search) { return std::vector<capture::FoundCamera>(); };
  SetupWindow window(services_);
  window.resize(1280, 720);
  window.show();
  QApplication::setActiveWindow(&window);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.presenter().sentence().contains("type the address"); }));
  std::vector<QLineEdit*> typed;
  for (auto* box : window.findChildren<QComboBox*>())
    if (box->isVisible() && box->isEditable()) typed.push_back(box->lineEdit());
  ASSERT_EQ(typed.size(), 3u) << "left, right, size";
  typed[0]->setFocus();
  QTest::keyClicks(typed[0], "/no/such/left.mkv");
  QTest::keyClick(typed[0], Qt::Key_Return);
  EXPECT_EQ(window.presenter().left(), "/no/such/left.mkv");
  EXPECT_EQ(typed[0]->text(), "/no/such/left.mkv") << "what was typed stays";
  typed[1]->setFocus();
  QTest::keyClicks(typed[1], "2");
  QTest::keyClick(typed[1], Qt::Key_Tab);
  EXPECT_EQ(window.presenter().right(), "2");
  QStringList shown;
  for (auto* label : window.findChildren<QLabel*>("fault"))
    if (label->isVisible()) shown << label->text();
  ASSERT_EQ(shown.size(), 2) << shown.join(" | ").toStdString();
  EXPECT_TRUE(shown[0].contains("there is no such file or folder")) << shown[0].toStdString();
  EXPECT_TRUE(shown[1].contains("there is no such camera")) << shown[1].toStdString();
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
    for (const QSize& size : {QSize(1280, 720), QSize(1366, 768)}) {
      window.resize(size);
      QTest::qWait(150);
      window.grab().save(QString("%1/setup_typed_%2.png").arg(pictures).arg(size.width()));
    }
}

struct ShownSize {
  QSize size;
  const char* name;
};

TEST_F(SetupTest, TheWindowShowsEveryPageAtEverySize) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto take = [](QWidget& window, const QString& name) {
    QTest::qWait(80);  // longer than the window's refresh
    if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
      window.grab().save(QString("%1/setup_%2.png").arg(pictures, name));
  };
  const std::vector<ShownSize> usual = {{{1280, 720}, "1280"}, {{1366, 768}, "1366"}, {{1920, 1080}, "1920"}},
                               doubled = {{{1366, 768}, "1366_double"}};
  for (const double scale : {1.0, 2.0}) {
    applyAppearance(*qApp, scale);
    const auto& sizes = scale == 1.0 ? usual : doubled;
    rigs_.clear();
    room_->shows = RoomShows::marker;
    SetupWindow window(services_);
    auto& setup = window.presenter();
    const auto takeAll = [&](const QString& page) {
      for (const auto& each : sizes) {
        window.resize(each.size);
        take(window, page + "_" + each.name);
        EXPECT_EQ(window.size(), each.size) << "no words widen the window: " << page.toStdString();
      }
    };
    window.resize(sizes.front().size);
    window.show();
    ASSERT_TRUE(fixtures::waitFor([&] { return setup.canOpen(); }));
    ASSERT_NO_FATAL_FAILURE(open(setup));
    takeAll("1");
    ASSERT_NO_FATAL_FAILURE(go(setup, RoomShows::held_board, Step::calibrate));
    ASSERT_TRUE(fixtures::waitFor([&] { return setup.view()->views >= 4; }, 60000));
    takeAll("2");
    ASSERT_TRUE(done(setup, Step::calibrate)) << setup.sentence().toStdString();
    takeAll("2_done");
    ASSERT_NO_FATAL_FAILURE(go(setup, RoomShows::one_place, Step::check));
    ASSERT_TRUE(says(setup, "now move it nearer or farther"));
    takeAll("3_one_place");
    ASSERT_NO_FATAL_FAILURE(go(setup, RoomShows::new_place, Step::check));
    ASSERT_TRUE(done(setup, Step::check)) << setup.sentence().toStdString();
    takeAll("3");
    ASSERT_TRUE(setup.keep(false));
    ASSERT_NO_FATAL_FAILURE(go(setup, RoomShows::marker, Step::coil));
    ASSERT_TRUE(done(setup, Step::coil)) << setup.sentence().toStdString();
    takeAll("4");
    room_->shows = RoomShows::nothing;
    ASSERT_TRUE(says(setup, "both cameras see its marker"));
    takeAll("4_none");
    room_->shows = RoomShows::other_marker;
    ASSERT_TRUE(says(setup, "this is another coil"));
    takeAll("4_other");
    room_->shows = RoomShows::marker;
    setup.startPivots();
    ASSERT_TRUE(says(setup, "the coil stands still: turn it"));
    takeAll("4_still");
    setup.startJig(jigFile(12));
    ASSERT_TRUE(says(setup, "the jig's (4x4_50 id 12) is not"));
    takeAll("4_no_jig");
    setup.startJig(jigFile(7));
    ASSERT_TRUE(says(setup, "the jig carries the same marker as the coil"));
    EXPECT_FALSE(setup.view()->is_done);
    takeAll("4_same_jig");
    setup.startWave();
    ASSERT_TRUE(says(setup, "wave the coil quicker"));
    takeAll("4_wave");
    room_->shows = RoomShows::nothing;  // a marker does not jump from place to place
    ASSERT_TRUE(says(setup, "both cameras see its marker"));
    room_->shows = RoomShows::waved_marker;
    ASSERT_TRUE(says(setup, "the shutter is known"));
    ASSERT_TRUE(says(setup, "kept with the pair"));
    takeAll("4_waved");
    EXPECT_NEAR(learnt_.row_times_s.value()[0], testing::kWaveRow_s, 0.1 * testing::kWaveRow_s);
  }
  applyAppearance(*qApp, 1.0);
  BoardScreen screen(testing::kPrintedBoard);
  screen.setAttribute(Qt::WA_DeleteOnClose, false);
  screen.resize(1280, 720);
  screen.show();
  take(screen, "board");
  const QImage shown = screen.grab().toImage().convertToFormat(QImage::Format_Grayscale8);
  const cv::Mat grey(shown.height(), shown.width(), CV_8U, const_cast<uchar*>(shown.bits()),
                     std::size_t(shown.bytesPerLine()));
  EXPECT_EQ(cameras::findBoard(grey.clone(), testing::kPrintedBoard).px.size(), 54u);
}

/// A simulated camera films the window with a delay of 40 ms.
TEST_F(SetupTest, TheDelayFromTheCameraToTheScreenIsMeasured) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  LatencyScreen* shown = nullptr;
  std::deque<std::shared_ptr<const cameras::StereoFrame>> on_the_way;
  std::int64_t number = 0;
  LatencyScreen screen(
      [&]() -> std::shared_ptr<const cameras::StereoFrame> {
        if (!shown) return nullptr;
        const double now_s = Timestamp::now().s;
        if (on_the_way.empty() || now_s - on_the_way.back()->captured.s > 0.01) {
          const QImage grabbed = shown->grab(QRect(0, 0, 80, 60)).toImage();
          auto frame = std::make_shared<cameras::StereoFrame>();
          frame->left = cv::Mat(60, 80, CV_8U, cv::Scalar(qGray(grabbed.pixel(40, 30))));
          frame->captured = {now_s};
          frame->number = ++number;
          on_the_way.push_back(frame);
        }
        std::shared_ptr<const cameras::StereoFrame> arrived;
        for (const auto& frame : on_the_way)
          if (frame->captured.s + 0.04 <= now_s) arrived = frame;
        while (on_the_way.size() > 40) on_the_way.pop_front();
        return arrived;
      },
      nullptr, 12);
  shown = &screen;
  screen.resize(640, 480);
  screen.show();
  ASSERT_TRUE(fixtures::waitFor([&] { return !screen.words().isEmpty(); }, 60000));
  ASSERT_TRUE(screen.words().startsWith("camera to screen: ")) << screen.words().toStdString();
  const int median_ms = screen.words().mid(18).section(' ', 0, 0).toInt();
  EXPECT_GE(median_ms, 40);
  EXPECT_LT(median_ms, 400);  // the machine may be busy
}

}  // namespace
}  // namespace facenav::ui
