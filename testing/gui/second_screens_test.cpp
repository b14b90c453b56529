// Guidance alone on a second screen, the projector's window, and the check of the alignment by eye, in a
// running session. FACENAV_GUI_PICTURES=DIR keeps images.

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>
#include <cstdlib>
#include <fstream>

#include "facenav/casefile/kept_session.h"
#include "facenav/scene/display.h"
#include "shell/main_window.h"
#include "treat/guidance_screen.h"
#include "treat/projector_screen.h"
#include "treat/tip_panel.h"
#include "treat/treat_workspace.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;

void keepPicture(QWidget& widget, const char* name) {
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
    widget.grab().save(QString("%1/%2.png").arg(pictures, name));
}

guidance::GuidanceState adjusting(guidance::Action action, const guidance::GuidanceValues& values,
                                  const char* words) {
  guidance::GuidanceState state;
  state.state = guidance::State::adjust;
  state.action = action;
  state.values = values;
  state.instruction = words;
  return state;
}

ReadOut readOutOf(const guidance::GuidanceState& guidance) {
  session::NavigationState state;
  state.head = Tracked<head_tracking::HeadPose>(head_tracking::HeadPose(), 0.9);
  state.coil = Tracked<coil_tracking::CoilPose>(coil_tracking::CoilPose(), 0.9);
  state.is_aligned = true;
  state.camera_T_mri = {RigidTransform<Camera, Mri>(), 0.9};
  state.camera_T_coil = {RigidTransform<Camera, Coil>(), 0.9};
  state.guidance = guidance;
  return makeReadOut(state);
}

TEST(GuidanceScreen, SaysWordFigureDistanceAndTheArrowsWay) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  QWidget page;
  auto* screen = new GuidanceScreen(&page);
  screen->resize(1280, 720);
  screen->show();
  guidance::GuidanceValues values{};
  values.distance_mm = 12.6, values.lateral_mm = 12.4, values.depth_mm = -2;
  values.lateral_in_coil_mm = {-12.4,
                               0};  // the target lies at the coil's -x: to the right, seen from behind it
  auto state = adjusting(guidance::Action::move, values, "move 12 mm to the patient's left");
  screen->set(state, readOutOf(state));
  EXPECT_EQ(screen->word(), "MOVE");
  EXPECT_EQ(screen->figure(), "12.4 mm");
  EXPECT_EQ(screen->distance(), "12.6 mm away");
  ASSERT_TRUE(screen->arrow_rad());
  EXPECT_NEAR(*screen->arrow_rad(), 0, 1e-9);
  QTest::qWait(50);
  keepPicture(*screen, "second_move");
  values.lateral_in_coil_mm = {0, 12.4};  // away from the handle: up
  state = adjusting(guidance::Action::move, values, "move 12 mm towards the face");
  screen->set(state, readOutOf(state));
  EXPECT_NEAR(*screen->arrow_rad(), M_PI / 2, 1e-9);
  values.tilt_rad = 0.14, values.tilt_in_coil_rad = {0.14, 0};
  state = adjusting(guidance::Action::tilt, values, "tilt the handle side up 8\u00b0");
  screen->set(state, readOutOf(state));
  EXPECT_EQ(screen->word(), "TILT");
  EXPECT_EQ(screen->figure(), QString("8\u00b0"));
  EXPECT_FALSE(screen->arrow_rad());
  QTest::qWait(50);
  keepPicture(*screen, "second_tilt");
  values.twist_rad = 0.3;
  state =
      adjusting(guidance::Action::turn, values, "turn counterclockwise seen from above the coil 17\u00b0");
  screen->set(state, readOutOf(state));
  QTest::qWait(50);
  keepPicture(*screen, "second_turn");
  state = adjusting(guidance::Action::lift, values, "lift the coil 2 mm");
  screen->set(state, readOutOf(state));
  EXPECT_EQ(screen->word(), "LIFT");
  QTest::qWait(50);
  keepPicture(*screen, "second_lift");
  state.state = guidance::State::on_target;
  state.action = guidance::Action::hold;
  state.instruction = "hold";
  screen->set(state, readOutOf(state));
  EXPECT_EQ(screen->word(), "HOLD");
  QTest::qWait(50);
  keepPicture(*screen, "second_hold");
}

TEST(GuidanceScreen, WhenLostNoFigureIsLeft) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  QWidget page;
  auto* screen = new GuidanceScreen(&page);
  screen->resize(1280, 720);
  screen->show();
  session::NavigationState lost;
  lost.head = Lost{LostReason::no_face};
  lost.is_aligned = true;
  lost.guidance.instruction = session::lossInWords(lost);
  screen->set(lost.guidance, makeReadOut(lost));
  EXPECT_FALSE(screen->word().isEmpty());
  EXPECT_EQ(screen->figure(), "");
  EXPECT_EQ(screen->distance(), "");
  EXPECT_FALSE(screen->arrow_rad());
  QTest::qWait(50);
  keepPicture(*screen, "second_lost");
}

cameras::ProjectorModel someProjector() {
  cameras::ProjectorModel projector;
  projector.width_px = 320, projector.height_px = 240;
  projector.lens.k = cv::Matx33d(300, 0, 159.5, 0, 300, 119.5, 0, 0, 1);
  projector.projector_T_camera = {Eigen::Quaterniond::Identity(), {0, 60, 0}};
  return projector;
}

class TreatCheck : public ::testing::Test {
 protected:
  Services services() {
    Services services = fakeServices();
    services.seeAlignment = [](const casefile::CaseStore& store, const steps::AlignmentOutcome&) {
      const auto scalp = store.scalp();
      const std::vector<surface::NamedPlace> places{{"nose tip", Point<Mri>(0, 90, 0), 1.0}};
      return steps::AlignmentSeen{
          std::make_shared<const pictures::AlignedSkin>(pictures::makeAlignedSkin(scalp.mesh, places)),
          std::make_shared<const guidance::TipCheck>(scalp.mesh, places)};
    };
    return services;
  }
  void guide(MainWindow& window) {
    case_folder_ = plannedCase(folder_.path(), true);
    window.show();
    window.openCase(QString::fromStdString(case_folder_.string()));
    const auto recording = writeRecording(folder_.path(), 3000);
    cameras::writeProjector(someProjector(), recording / "projector.yml");
    window.play(QString::fromStdString(recording.string()), true);
    window.setWorkspace(Workspace::treat);
    ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }));
    ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().state()->frame > 2; }));
  }
  /// The window's tool Check, while guidance runs.
  TipPresenter& checkTool(MainWindow& window) {
    guide(window);
    auto* treat = window.findChild<TreatWorkspace*>();
    treat->showTool(TreatWorkspace::Tool::check);
    return treat->tip();
  }
  testing::TemporaryFolder folder_;
  std::filesystem::path case_folder_;
};

TEST_F(TreatCheck, ThePersonsJudgementOfTheTipIsAnEvent) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window(services());
  auto& tip = checkTool(window);
  auto* treat = window.findChild<TreatWorkspace*>();
  ASSERT_TRUE(fixtures::waitFor([&] { return tip.reading().has_value(); }));
  // The coil is at kMarker, the head at the fakes' reference; the case's head is a ball of 90 mm.
  const Eigen::Vector3d tip_mm = (fakes::cameraAtReference().inverse() * Point<Camera>(20, -60, 550)).mm;
  EXPECT_NEAR(tip.reading()->off_skin_mm, tip_mm.norm() - 90, 0.5);
  EXPECT_EQ(tip.canJudge(), std::abs(tip_mm.norm() - 90) < guidance::TipReading::kNear_mm);
  ASSERT_TRUE(tip.canJudge());
  EXPECT_EQ(tip.offSkin(), QString::number(std::abs(tip.reading()->off_skin_mm), 'f', 1));
  QTest::qWait(100);
  keepPicture(window, "treat_check");
  const std::string words = inWords(*tip.reading());
  QPushButton* right = nullptr;
  for (auto* button : treat->findChild<TipPanel*>()->findChildren<QPushButton*>())
    if (button->text().contains("Matches")) right = button;
  ASSERT_NE(right, nullptr);
  right->click();
  EXPECT_TRUE(tip.words().contains("matches: ")) << tip.words().toStdString();
  treat->presenter().end();
  std::string events;
  ASSERT_TRUE(fixtures::waitFor([&] {
    events.clear();
    const auto session = casefile::readSession(casefile::findSession(case_folder_, ""));
    for (const auto& event : session.events) events += event.event + ": " + event.detail + "\n";
    return events.find("session ended") != std::string::npos;
  }));
  EXPECT_NE(events.find("tip check: judged right: " + words), std::string::npos) << events;
}

TEST_F(TreatCheck, AnAlignmentThatWasJudgedWrongGuidesNobodyAndStartsNoOtherSession) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window(services());
  auto& tip = checkTool(window);
  TreatPresenter& treat = window.findChild<TreatWorkspace*>()->presenter();
  ASSERT_TRUE(fixtures::waitFor([&] { return tip.canJudge(); }));
  tip.judge(steps::TipVerdict::wrong);
  EXPECT_TRUE(tip.words().contains("DOES NOT MATCH")) << tip.words().toStdString();
  EXPECT_TRUE(fixtures::waitFor([&] { return !treat.state()->camera_T_mri; }));
  treat.checkRegistration();
  QTest::qWait(300);
  EXPECT_FALSE(treat.state()->camera_T_mri);
  keepPicture(window, "treat_judged_wrong");
  treat.end();
  EXPECT_FALSE(treat.isAligned());
  treat.start();
  QTest::qWait(200);
  EXPECT_FALSE(treat.isRunning());
  EXPECT_FALSE(std::filesystem::exists(case_folder_ / "alignment.json"));
}

TEST_F(TreatCheck, AClickedSpotThatTheOtherPictureDoesNotShowIsNotMeasured) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window(services());
  auto& tip = checkTool(window);
  const auto state = window.treat().state();
  ASSERT_TRUE(state->images);
  const QPointF middle(0.5 * state->images->left.cols, 0.5 * state->images->left.rows);
  tip.pick(stereo::PictureSide::left, middle, *state);  // the pictures are uniform
  EXPECT_FALSE(tip.words().contains("The clicked spot")) << tip.words().toStdString();
  EXPECT_FALSE(tip.canJudge()) << "the figures beside that refusal are the coil's";
  tip.pick(stereo::PictureSide::right, {-50, 2}, *state);
  EXPECT_TRUE(tip.words().contains("outside the picture")) << tip.words().toStdString();
  EXPECT_TRUE(!tip.reading() || tip.reading()->what == guidance::TipReading::What::coil_tip);
}

TEST_F(TreatCheck, TheSecondScreensFollowTheSessionAndGoDarkWithIt) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  MainWindow window(services());
  guide(window);
  auto* treat = window.findChild<TreatWorkspace*>();
  auto& screens = treat->screens();
  screens.showGuidance(true);
  ASSERT_TRUE(screens.guidance());
  EXPECT_TRUE(fixtures::waitFor([&] { return screens.guidance()->word() == "HOLD"; }));
  EXPECT_EQ(treat->projector().knownFile(),
            QString::fromStdString((folder_.path() / "recording/projector.yml").string()));
  ASSERT_TRUE(treat->projector().open(treat->projector().knownFile()));
  screens.showProjector(true);
  ASSERT_TRUE(screens.projector());
  EXPECT_TRUE(fixtures::waitFor([&] { return !screens.projector()->isBlack(); }));
  keepPicture(*screens.projector(), "projector_window");
  window.setWorkspace(Workspace::plan);  // the screens continue while another page is shown
  treat->presenter().chooseTarget("");
  EXPECT_TRUE(fixtures::waitFor([&] { return screens.guidance()->figure().isEmpty(); }))
      << "without a target there is no figure";
  treat->presenter().end();
  EXPECT_TRUE(fixtures::waitFor([&] { return screens.projector()->isBlack(); }));
  screens.guidance()->close();
  screens.showProjector(false);
  EXPECT_FALSE(screens.areShown());
}

}  // namespace
}  // namespace facenav::ui
