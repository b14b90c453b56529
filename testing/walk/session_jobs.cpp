#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QSettings>
#include <QTableView>
#include <QTextBrowser>

#include "gui/home_fixtures.h"
#include "home/home_window.h"
#include "jobs.h"
#include "prepare/prepare_workspace.h"
#include "setup/setup_window.h"
#include "shell/main_window.h"
#include "treat/treat_workspace.h"

namespace facenav::walk {
namespace {

using ui::MainWindow;
using Page = Robot::Page;
namespace fs = std::filesystem;
namespace fakes = session::fakes;

/// Services whose trackers see the head still and the coil at the case's target.
ui::Services atTarget(ui::Services services, const fs::path& case_folder) {
  const auto target = casefile::CaseStore::open(case_folder).targets().targets.front();
  const auto coil = fakes::cameraAtReference() * target.mri_T_target.reframe<Mri, Coil>();
  const auto fake = ui::treat_fixtures::fakeServices();
  services.align = fake.align;
  services.seeAlignment = {};
  services.listCameras = [](capture::Search) { return std::vector<capture::FoundCamera>(); };
  services.listRigs = [] { return std::vector<capture::RigEntry>(); };
  services.makeNavigator = [coil](const session::NavigatorSetup& setup) {
    return std::make_unique<session::Navigator>(
        setup, std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
        std::make_unique<fakes::Coil>(coil.reframe<Camera, Marker>()));
  };
  return services;
}

/// Looks at the first page of the camera set-up, which has a window of its own, and closes it.
void lookAtSetUp(Robot& robot, MainWindow& window, const Look& look) {
  robot.step(
      "set-up opens", Page::stays, [&] { robot.press("Set up the cameras\u2026"); },
      [&] { return window.findChild<ui::SetupWindow*>() != nullptr; });
  if (robot.hasFailed()) return;
  QPointer<ui::SetupWindow> set_up = window.findChild<ui::SetupWindow*>();
  {
    Robot hand(*set_up, "set-up", look);
    hand.step(
        "place", Page::changes, [] {}, [&] { return set_up->isVisible(); });
  }
  robot.step(
      "set-up closed", Page::stays, [&] { set_up->close(); },
      [&] { return !set_up || !set_up->isVisible(); });
}

void align(Robot& robot, MainWindow& window, const fs::path& recording) {
  robot.step(
      "recording", Page::stays,
      [&] {
        robot.answerFolder(pathOf(recording));
        robot.press("Open a recording\u2026");
      },
      [&] { return window.treat().hasRecording() && !window.tasks().isRunning(); });
  robot.step(
      "aligned", Page::changes, [&] { robot.press("2 Align"); },
      [&] { return window.treat().isAligned() && !window.tasks().isRunning(); }, 120000);
}

void guide(Robot& robot, MainWindow& window) {
  const auto& treat = window.treat();
  robot.step(
      "guiding", Page::stays, [&] { robot.press("3 Guide"); },
      [&] { return treat.isGuiding() && treat.state()->frame > 2; });
  robot.step(
      "pulse", Page::stays, [&] { robot.key(Qt::Key_P); },
      [&] { return treat.pulseCounts().on_target == 1; });
  robot.step(
      "session tools", Page::changes, [&] { robot.pressTab("Session"); },
      [&] { return part<QComboBox>(window, "pain before") != nullptr; });
  robot.step(
      "pause", Page::changes, [&] { robot.press("Pause"); }, [&] { return treat.isPaused(); });
  robot.step(
      "go on", Page::changes, [&] { robot.press("Go on guiding"); }, [&] { return treat.isGuiding(); });
  robot.step(
      "stopped", Page::changes, [&] { robot.key(Qt::Key_Space); },
      [&] { return treat.isPaused() && !treat.isEnding(); });
}

void endAndReport(Robot& robot, MainWindow& window) {
  robot.step(
      "ending", Page::changes, [&] { robot.key(Qt::Key_E, Qt::ControlModifier); },
      [&] { return window.treat().isEnding(); });
  robot.step(
      "report", Page::changes, [&] { robot.press("End and show the report"); },
      [&] { return window.workspace() == ui::Workspace::review && !window.review().isReading(); });
  robot.step(
      "report read", Page::changes, [&] { robot.press("Report"); },
      [&] {
        const auto* report = part<QTextBrowser>(window, "report");
        return report && report->toPlainText().contains("M1 hand R");
      });
  robot.step(
      "pulses", Page::changes, [&] { robot.press("Pulses"); },
      [&] { return part<QTextBrowser>(window, "report") == nullptr; });
}

/// Opens the case from the worklist and goes to Treat.
void openCase(Robot& robot, MainWindow& window) {
  robot.step(
      "start", Page::changes, [] {}, [&] { return window.worklist().rows().size() == 1; });
  robot.step(
      "open", Page::changes,
      [&] {
        auto* table = part<QTableView>(window, "worklist");
        robot.clickAt(*table->viewport(), table->visualRect(table->model()->index(0, 0)).center());
        robot.press("Open");
      },
      [&] { return window.prepareStep() == ui::PrepareStep::check && !window.tasks().isRunning(); });
  robot.step(
      "treat", Page::changes, [&] { robot.press("Treat"); },
      [&] { return window.workspace() == ui::Workspace::treat; });
}

}  // namespace

void treat(Patient& patient, const Look& look) {
  QSettings().clear();
  const fs::path cases = patient.casesFolder(std::string("treated ") + look.name);
  MainWindow window(atTarget(patient.services(), cases / "patient"));
  window.show();
  window.setCasesFolder(pathOf(cases));
  Robot robot(window, "clinician", look);
  openCase(robot, window);
  if (robot.hasFailed()) return;
  lookAtSetUp(robot, window, look);
  align(robot, window, patient.recording());
  guide(robot, window);
  endAndReport(robot, window);
}

void treatInTheRoom(Patient& patient, const Look& look) {
  QSettings().clear();
  const fs::path recording = patient.roomRecording(), cases = patient.casesFolder("treated in the room");
  ASSERT_TRUE(fs::exists(recording)) << "facenav simulate made none";
  auto services = patient.services();
  services.listCameras = [](capture::Search) { return std::vector<capture::FoundCamera>(); };
  services.listRigs = [] { return std::vector<capture::RigEntry>(); };
  MainWindow window(services);
  window.show();
  window.setCasesFolder(pathOf(cases));
  Robot robot(window, "clinician in the room", look);
  openCase(robot, window);
  align(robot, window, recording);
  const auto& treat = window.treat();
  robot.step(
      "guiding", Page::stays, [&] { robot.press("3 Guide"); },
      [&] {
        const auto state = treat.state();
        return treat.isGuiding() && state && state->camera_T_mri && state->coil;
      },
      60000);
  robot.step(
      "ending", Page::changes, [&] { robot.key(Qt::Key_E, Qt::ControlModifier); },
      [&] { return treat.isEnding(); });
}

void treatAtHome(Patient& patient, const Look& look) {
  QSettings().clear();
  qputenv("HOME", QByteArray::fromStdString((patient.folder() / "home").string()));
  const testing::TemporaryFolder folder;
  ui::HomeWindow window(ui::home_fixtures::homeServices(std::make_shared<ui::home_fixtures::Seen>()));
  auto& home = window.presenter();
  window.resize(look.size);
  window.show();
  home.open(pathOf(ui::home_fixtures::writeHomeCase(folder.path())));
  ui::fixtures::waitFor([&] { return home.stage() == ui::HomePresenter::Stage::sit; });
  home.play(pathOf(patient.recording()));
  Robot robot(window, "home", look);
  robot.step(
      "sit", Page::changes, [] {}, [&] { return home.hasPictures(); });
  robot.step(
      "guiding", Page::stays, [&] { robot.key(Qt::Key_Return); },
      [&] {
        return home.stage() == ui::HomePresenter::Stage::guiding &&
               home.advice().sign == steps::HomeSign::hold;
      });
  robot.step(
      "pulse", Page::stays, [&] { robot.key(Qt::Key_P); }, [&] { return home.pulseCounts().on_target == 1; });
  robot.step(
      "asked", Page::stays, [&] { robot.key(Qt::Key_Return); }, [&] { return home.asksToFinish(); });
  robot.step(
      "finished", Page::stays, [&] { robot.key(Qt::Key_Return); },
      [&] {
        return home.stage() == ui::HomePresenter::Stage::ended && home.actionWords().startsWith("SAVE");
      });
  robot.step(
      "saved", Page::stays, [&] { robot.key(Qt::Key_Return); }, [&] { return !home.savedAs().isEmpty(); });
  if (robot.hasFailed()) return;
  EXPECT_TRUE(QFile::exists(home.savedAs())) << home.savedAs().toStdString();
}

}  // namespace facenav::walk
