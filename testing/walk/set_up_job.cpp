#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QSettings>

#include "jobs.h"
#include "setup/setup_window.h"
#include "support/setup_services.h"

namespace facenav::walk {
namespace {

using Page = Robot::Page;
using Step = steps::SetupStep;
using testing::RoomShows;

constexpr int kCalibration_ms = 120000;

/// True once the step is done with what the cameras show now.
bool isDone(const ui::SetupPresenter& setup, Step step) {
  return setup.view()->step == step && setup.view()->is_done && setup.view()->frame;
}

}  // namespace

void setUpCameras(Patient&, const Look& look) {
  QSettings().clear();
  QSettings().setValue("setup/size", "640x480");
  const auto room = std::make_shared<testing::SetupRoom>();
  const auto rigs = std::make_shared<std::vector<capture::RigEntry>>();
  ui::SetupWindow window(testing::setupServices(room, rigs));
  auto& setup = window.presenter();
  setup.setBoard(9, 6, 20.0);  // the board that the room shows
  window.show();
  Look live = look;
  live.pictures = nullptr;  // the pictures of the cameras change all the time
  Robot robot(window, "set-up", live);
  robot.step(
      "cameras", Page::changes, [] {}, [&] { return setup.canOpen(); });
  robot.step(
      "open", Page::changes, [&] { robot.press("Open the cameras"); },
      [&] { return setup.isOpen() && setup.view()->frame; });
  room->shows = RoomShows::held_board;
  robot.step(
      "calibrate", Page::changes, [&] { robot.press("Go on"); },
      [&] { return setup.step() == Step::calibrate && setup.view()->views > 0; }, kCalibration_ms);
  robot.step(
      "calibrated", Page::stays, [] {}, [&] { return isDone(setup, Step::calibrate); }, kCalibration_ms);
  room->shows = RoomShows::new_place;
  robot.step(
      "check", Page::changes, [&] { robot.press("Go on"); }, [&] { return isDone(setup, Step::check); },
      kCalibration_ms);
  robot.step(
      "kept", Page::stays, [&] { robot.press("Keep it"); }, [&] { return setup.isKept(); });
  room->shows = RoomShows::marker;
  robot.step(
      "coil", Page::changes, [&] { robot.press("Go on"); }, [&] { return isDone(setup, Step::coil); },
      kCalibration_ms);
  robot.step(
      "pivoting", Page::stays, [&] { robot.press("Calibrate by pivoting"); },
      [&] { return setup.sentence().contains("the coil stands still"); }, kCalibration_ms);
  robot.step(
      "closed", Page::changes, [&] { robot.press("Close"); }, [&] { return !window.isVisible(); });
  if (robot.hasFailed()) return;
  ASSERT_EQ(rigs->size(), 1u);
  EXPECT_EQ(rigs->front().rig->left->identity.serial, "A");
}

}  // namespace facenav::walk
