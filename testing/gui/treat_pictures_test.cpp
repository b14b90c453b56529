// Treat and the home window with a real face: real trackers, a recording of the virtual room played as if
// live, images for people to look at. FACENAV_GUI_CASES=DIR is a folder whose first case is treated (use a
// copy), FACENAV_GUI_RECORDING=DIR its recording, FACENAV_GUI_HOME=DIR a home case of the same person (may be
// missing), FACENAV_GUI_PICTURES=DIR the output. Skipped without them.

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "facenav/casefile/sign_off.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "home/home_window.h"
#include "registrations.h"
#include "shell/appearance.h"
#include "shell/main_window.h"
#include "shell/second_screens.h"
#include "treat/guidance_screen.h"
#include "treat/projector_screen.h"
#include "treat/treat_workspace.h"

namespace facenav::ui {
namespace {

namespace fs = std::filesystem;
using Tool = TreatWorkspace::Tool;

const char* fromEnvironment(const char* name) { return std::getenv(name); }

class TreatPictures : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!recording_ || !pictures_) GTEST_SKIP() << "FACENAV_GUI_RECORDING and _PICTURES are not set";
    if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  }
  void TearDown() override { applyAppearance(*qApp); }
  void take(QWidget& widget, const QString& name) const {
    fixtures::waitFor([] { return false; }, 700);  // time to draw
    EXPECT_TRUE(widget.grab().save(QString("%1/%2.png").arg(pictures_, name)));
  }
  const char *recording_ = fromEnvironment("FACENAV_GUI_RECORDING"),
             *pictures_ = fromEnvironment("FACENAV_GUI_PICTURES");
  const std::vector<std::tuple<QString, QSize, double>> sizes_{
      {"1366", QSize(1366, 768), 1.0}, {"1920", QSize(1920, 1080), 1.0}, {"doubled", QSize(1920, 1080), 2.0}};
};

template <class Screen>
Screen* shownScreen() {
  for (auto* widget : QApplication::topLevelWidgets())
    if (auto* screen = widget->findChild<Screen*>(); screen && screen->isVisible()) return screen;
  for (auto* widget : QApplication::topLevelWidgets())
    if (auto* screen = dynamic_cast<Screen*>(widget); screen && screen->isVisible()) return screen;
  return nullptr;
}

TEST_F(TreatPictures, OfTheToolsAndTheOtherScreens) {
  const char* cases = fromEnvironment("FACENAV_GUI_CASES");
  if (!cases) GTEST_SKIP() << "FACENAV_GUI_CASES is not set";
  const fs::path case_folder = casefile::listCases(cases).front().folder;
  for (const auto& [name, size, scale] : sizes_) {
    applyAppearance(*qApp, scale);
    MainWindow window(servicesWith(app::makeRegistrations));
    window.resize(size);
    window.show();
    window.openCase(QString::fromStdString(case_folder.string()));
    ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }, 90000));
    window.setWorkspace(Workspace::treat);
    window.play(recording_, true);
    ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }, 240000));
    fixtures::waitFor([&] { return window.treat().state()->guidance.state == guidance::State::on_target; },
                      10000);
    auto* treat = window.findChild<TreatWorkspace*>();
    for (const auto& [tool, words] : {std::pair(Tool::aim, "aim"), {Tool::check, "check"}}) {
      treat->showTool(tool);
      take(window, QString("treat_%1_%2").arg(words, name));
    }
    const auto state = window.treat().state();
    ASSERT_TRUE(state->images);
    treat->tip().pick(stereo::PictureSide::left,
                      {0.5 * state->images->left.cols, 0.5 * state->images->left.rows}, *state);
    fixtures::waitFor([] { return false; }, 300);
    take(window, "treat_spot_" + name);
    treat->projector().open(QString("%1/projector.yml").arg(recording_));
    treat->screens().showGuidance(true);
    treat->screens().showProjector(true);
    fixtures::waitFor([] { return false; }, 500);
    if (auto* screen = shownScreen<GuidanceScreen>()) take(*screen, "second_" + name);
    if (auto* screen = shownScreen<ProjectorScreen>()) take(*screen, "projector_" + name);
    treat->screens().showGuidance(false);
    treat->screens().showProjector(false);
    EXPECT_EQ(window.size(), size) << "no words widen the window";
  }
}

/// The live field over the case's brain, and what tracking feels of it.
TEST_F(TreatPictures, OfTheLiveField) {
  const char* cases = fromEnvironment("FACENAV_GUI_CASES");
  if (!cases) GTEST_SKIP() << "FACENAV_GUI_CASES is not set";
  const fs::path case_folder = casefile::listCases(cases).front().folder;
  QSettings().setValue("plan/field_rate", 66.0);
  MainWindow window(servicesWith(app::makeRegistrations));
  window.resize(1920, 1080);
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }, 90000));
  window.setWorkspace(Workspace::treat);
  auto* treat = window.findChild<TreatWorkspace*>();
  for (const bool is_on : {false, true, false, true}) {
    treat->field().setOn(is_on);
    window.play(recording_, true);
    ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }, 240000));
    window.setWorkspace(Workspace::treat);  // a case that is opened shows its own step
    fixtures::waitFor([&] { return window.treat().state()->frame > 30; }, 10000);
    if (is_on) ASSERT_TRUE(fixtures::waitFor([&] { return treat->field().picture().has_value(); }, 60000));
    const auto first = window.treat().state();
    std::vector<double> took_ms;
    std::int64_t last = first->frame;
    QElapsedTimer timer;
    timer.start();
    const int before = treat->field().computed();
    bool has_taken = false;
    while (window.treat().isRunning() && timer.elapsed() < 8000) {
      fixtures::waitFor([&] { return window.treat().state()->frame != last; }, 200);
      const auto state = window.treat().state();
      if (state->frame != last && state->frame >= 0) took_ms.push_back(state->processing_ms);
      last = state->frame;
      if (is_on && !has_taken && timer.elapsed() > 1500) {
        has_taken = true;
        EXPECT_TRUE(window.grab().save(QString("%1/treat_live_field.png").arg(pictures_)));
      }
    }
    const double seconds = 1e-3 * double(timer.elapsed());
    std::sort(took_ms.begin(), took_ms.end());
    const auto state = window.treat().state();
    std::printf(
        "field %s: %zu states seen in %.1f s, tracking %.2f ms median, %.2f ms p95, %.1f fields/s; %s\n",
        is_on ? "on" : "off", took_ms.size(), seconds, took_ms.empty() ? 0.0 : took_ms[took_ms.size() / 2],
        took_ms.empty() ? 0.0 : took_ms[took_ms.size() * 95 / 100],
        double(treat->field().computed() - before) / seconds, treat->field().words().toStdString().c_str());
    treat->presenter().end();
    fixtures::waitFor([] { return false; }, 1500);
  }
  QSettings().clear();
}

TEST_F(TreatPictures, OfTheHomeWindow) {
  const char* home_case = fromEnvironment("FACENAV_GUI_HOME");
  if (!home_case) GTEST_SKIP() << "FACENAV_GUI_HOME is not set";
  for (const auto& [name, size, scale] : sizes_) {
    applyAppearance(*qApp, scale);
    HomeWindow window(servicesWith(app::makeRegistrations));
    window.resize(size);
    window.show();
    auto& home = window.presenter();
    home.open(home_case);
    ASSERT_TRUE(fixtures::waitFor([&] { return home.stage() != HomePresenter::Stage::opening; }, 60000));
    home.play(recording_);
    take(window, "home_sit_" + name);
    home.act();
    ASSERT_TRUE(fixtures::waitFor([&] { return home.stage() == HomePresenter::Stage::guiding; }, 240000))
        << home.words().toStdString();
    fixtures::waitFor([&] { return home.advice().step == steps::HomeStep::follow; }, 60000);
    home.countPulse();
    take(window, "home_follow_" + name);
    home.act();
    home.act();
    ASSERT_TRUE(fixtures::waitFor([&] { return home.stage() == HomePresenter::Stage::ended; }, 60000));
    take(window, "home_ended_" + name);
    EXPECT_EQ(window.size(), size) << "no words widen the window";
  }
}

}  // namespace
}  // namespace facenav::ui
