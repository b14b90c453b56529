#include "home_and_setup_pages.h"

#include <gtest/gtest.h>

#include <QSettings>

#include "home/home_window.h"
#include "home/sign_view.h"
#include "home_fixtures.h"
#include "setup/setup_window.h"
#include "shell/image_view.h"
#include "support/setup_services.h"

namespace facenav::ui::fixtures {
namespace {

using Stage = HomePresenter::Stage;
using Step = steps::SetupStep;
using testing::RoomShows;

constexpr int kCalibration_ms = 120000;

/// Opens the case and the recording in a window that waits for a person to sit down.
void openHome(HomeWindow& window, const std::filesystem::path& folder, const QSize& size) {
  auto& home = window.presenter();
  window.resize(size);
  window.show();
  home.open(QString::fromStdString((folder / "home").string()));
  ASSERT_TRUE(waitFor([&] { return home.stage() == Stage::sit; }));
  home.play(QString::fromStdString((folder / "recording").string()));
}

void refuseAtHome(const std::filesystem::path& folder, const QSize& size, const LookAt& look) {
  HomeWindow window(home_fixtures::homeServices(std::make_shared<home_fixtures::Seen>(), {0, 0, 0},
                                                "not aligned: the face does not fit this MRI"));
  ASSERT_NO_FATAL_FAILURE(openHome(window, folder, size));
  window.presenter().act();
  ASSERT_TRUE(waitFor([&] { return window.findChild<SignView*>()->isRefused(); }));
  look(window, "9_home_refused");
}

/// True once the step is done with what the cameras show now.
bool isDone(const SetupPresenter& setup, Step step) {
  return waitFor([&] { return setup.view()->step == step && setup.view()->is_done && setup.view()->frame; },
                 kCalibration_ms);
}

/// Names the cameras' pictures "live" while they change.
void markLive(const SetupWindow& window, bool are_live) {
  for (auto* view : window.findChildren<ImageView*>()) view->setObjectName(are_live ? "live" : "");
}

}  // namespace

void onEveryHomePage(const QSize& size, const LookAt& look) {
  testing::TemporaryFolder folder;
  home_fixtures::writeHomeCase(folder.path());
  home_fixtures::writeCapturedRecording(folder.path());
  const auto seen = std::make_shared<home_fixtures::Seen>();
  {
    HomeWindow window(home_fixtures::homeServices(seen, {9, -4, 0}));
    auto& home = window.presenter();
    const auto* sign = window.findChild<SignView*>();
    ASSERT_NO_FATAL_FAILURE(openHome(window, folder.path(), size));
    look(window, "9_home_sit");
    seen->coil = false;
    home.act();
    ASSERT_TRUE(waitFor(
        [&] { return home.stage() == Stage::guiding && home.advice().step == steps::HomeStep::hold; }));
    look(window, "9_home_hold");
    seen->coil = true;
    ASSERT_TRUE(waitFor([&] { return sign->sign() == steps::HomeSign::arrow; }));
    home.countPulse();
    ASSERT_TRUE(waitFor([&] { return home.pulseCounts().outside == 1; }));
    look(window, "9_home_follow");
    home.act();
    look(window, "9_home_finish");
    home.act();
    ASSERT_TRUE(waitFor([&] { return home.stage() == Stage::ended; }));
    look(window, "9_home_ended");
  }
  refuseAtHome(folder.path(), size, look);
}

void onEverySetUpPage(const QSize& size, const LookAt& look) {
  QSettings().setValue("setup/size", "640x480");
  const auto room = std::make_shared<testing::SetupRoom>();
  SetupWindow window(testing::setupServices(room, std::make_shared<std::vector<capture::RigEntry>>()));
  auto& setup = window.presenter();
  setup.setBoard(9, 6, 20.0);  // the board that the room shows
  room->shows = RoomShows::marker;
  window.resize(size);
  window.show();
  ASSERT_TRUE(waitFor([&] { return setup.canOpen(); }));
  look(window, "0_setup_choice");
  setup.open();
  ASSERT_TRUE(waitFor([&] { return setup.isOpen() && setup.view()->frame; }));
  look(window, "0_setup_place");
  markLive(window, true);
  room->shows = RoomShows::held_board;
  setup.go(Step::calibrate);
  ASSERT_TRUE(isDone(setup, Step::calibrate)) << setup.sentence().toStdString();
  look(window, "0_setup_calibrated");
  room->shows = RoomShows::new_place;
  setup.go(Step::check);
  ASSERT_TRUE(isDone(setup, Step::check)) << setup.sentence().toStdString();
  setup.setName("room 4");
  look(window, "0_setup_checked");
  ASSERT_TRUE(setup.keep(false));
  look(window, "0_setup_kept");
  markLive(window, false);
  room->shows = RoomShows::marker;
  setup.go(Step::coil);
  ASSERT_TRUE(isDone(setup, Step::coil)) << setup.sentence().toStdString();
  look(window, "0_setup_coil");
  QSettings().remove("setup/size");
}

}  // namespace facenav::ui::fixtures
