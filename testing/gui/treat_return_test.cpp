// An interrupted session is offered and continued, and the registration is checked again on request: by the
// presenters, without a window. FACENAV_GUI_PICTURES=DIR keeps images of the page with both.

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QtTest/QTest>
#include <atomic>
#include <cstdlib>
#include <fstream>

#include "facenav/casefile/kept_session.h"
#include "facenav/scene/display.h"
#include "shell/main_window.h"
#include "support/changed_settings.h"
#include "support/made_session.h"
#include "treat/treat_workspace.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;
using Verdict = monitoring::DriftFinding::Verdict;
namespace fs = std::filesystem;

/// Services with the trackers of fakeServices, and a registration check that returns a given verdict.
Services measuredServices(std::shared_ptr<std::atomic<Verdict>> verdict) {
  Services services = fakeServices();
  services.makeNavigator = [made = services.makeNavigator, verdict](const session::NavigatorSetup& setup) {
    auto navigator = made(setup);
    navigator->setCheck(std::make_unique<monitoring::RegistrationCheck>(
        [verdict](const cameras::StereoFrame&, const RigidTransform<Camera, Mri>&) {
          monitoring::DriftFinding finding;
          finding.verdict = *verdict;
          finding.shift_mm = finding.verdict == Verdict::agrees ? 0.4 : 4.2;
          finding.turn_deg = finding.verdict == Verdict::agrees ? 0.2 : 1.5;
          return finding;
        },
        monitoring::DriftWatchdog::Mode::in_line));
    return navigator;
  };
  return services;
}

std::string textOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Writes the session of a program that was killed after 40 pulses.
fs::path writeCutSession(const fs::path& case_folder) {
  const auto session = testing::writeMadeSession(
      case_folder, casefile::CaseStore::open(case_folder).targets().targets.front());
  const fs::path events = session / "events.jsonl";
  std::string text = textOf(events);
  text.erase(text.rfind('\n', text.size() - 2) + 1);  // removes "session ended"
  std::ofstream(events, std::ios::trunc) << text;
  return session;
}

class TreatReturn : public ::testing::Test {
 protected:
  void open(bool has_recording = true) {
    case_folder_ = plannedCase(folder_.path(), true);
    session_ = writeCutSession(case_folder_);
    TaskMonitor monitor;
    model_.open(loadCase(case_folder_, monitor));
    if (!has_recording) return;
    treat_.openRecording(QString::fromStdString(writeRecording(folder_.path(), 3000).string()));
    settle();
  }
  void settle() {
    fixtures::waitFor([&] { return !tasks_.isRunning(); });
  }
  /// Waits until the check's words begin so; follows the newest state as the page does.
  bool reads(const QString& words) {
    return fixtures::waitFor([&] {
      check_.follow(*treat_.state());
      return check_.words().startsWith(words);
    });
  }
  testing::TemporaryFolder folder_;
  std::shared_ptr<std::atomic<Verdict>> verdict_ = std::make_shared<std::atomic<Verdict>>(Verdict::agrees);
  Services services_ = measuredServices(verdict_);
  CaseModel model_;
  TaskRunner tasks_;
  TreatPresenter treat_{services_, model_, tasks_};
  ReturnPresenter return_{treat_, model_};
  CheckPresenter check_{treat_};
  fs::path case_folder_, session_;
};

TEST_F(TreatReturn, ACutSessionIsOfferedInOneSentence) {
  open(false);
  ASSERT_TRUE(return_.isOffered());
  for (const char* words : {"was cut off", "40 pulses are kept", "target spot"})
    EXPECT_TRUE(return_.words().contains(words)) << return_.words().toStdString();
  EXPECT_EQ(return_.missing(), "open the cameras first (step 1)");
  return_.goOn();
  EXPECT_FALSE(tasks_.isRunning());
  return_.beginNew();
  EXPECT_FALSE(return_.isOffered());
  EXPECT_EQ(textOf(session_ / "events.jsonl").find("session continued"), std::string::npos);
}

TEST_F(TreatReturn, GoingOnKeepsCountingAndGuidesOnlyAfterTheFaceWasMeasured) {
  *verdict_ = Verdict::drifted;
  open();
  return_.goOn();
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.isRunning(); }));
  EXPECT_FALSE(return_.isOffered());
  EXPECT_EQ(casefile::sessionFolders(case_folder_).size(), 1u) << "the same session";
  const auto counts = treat_.pulseCounts();
  EXPECT_EQ(counts.on_target + counts.outside + counts.lost, 40);
  EXPECT_EQ(treat_.targetName(), "spot");
  bool was_shown = false;
  EXPECT_TRUE(fixtures::waitFor([&] {
    const auto state = treat_.state();
    was_shown = was_shown || state->camera_T_mri;
    return state->withheld && state->withheld->reason == monitoring::Withheld::Reason::registration_failed;
  }));
  EXPECT_FALSE(was_shown) << "no pose before a check has passed";
  EXPECT_TRUE(reads("REGISTRATION FAILED: 4.2 mm, 1.5"));
  EXPECT_EQ(check_.level(), Level::lost);
  *verdict_ = Verdict::agrees;
  check_.begin();
  EXPECT_TRUE(reads("Registration passed: 0.4 mm, 0.2"));
  EXPECT_EQ(check_.level(), Level::good);
  EXPECT_TRUE(fixtures::waitFor([&] { return bool(treat_.state()->camera_T_mri); }));
  treat_.end();
  const std::string events = textOf(session_ / "events.jsonl");
  for (const char* words : {"session continued", "after 40 pulses", "failed: face 4.2 mm and 1.5 deg",
                            "passed: face 0.4 mm and 0.2 deg"})
    EXPECT_NE(events.find(words), std::string::npos) << words;
}

TEST_F(TreatReturn, ABadCheckDuringGuidanceTakesThePoseAway) {
  open();
  return_.beginNew();
  treat_.align(true);
  settle();
  ASSERT_TRUE(fixtures::waitFor([&] { return bool(treat_.state()->camera_T_mri); }));
  EXPECT_TRUE(reads("Registration: as aligned"));
  *verdict_ = Verdict::drifted;
  check_.begin();
  EXPECT_TRUE(check_.words().startsWith("Measuring the face for 2 s")) << check_.words().toStdString();
  EXPECT_TRUE(check_.isMeasuring());
  EXPECT_TRUE(reads("REGISTRATION FAILED"));
  EXPECT_FALSE(treat_.state()->camera_T_mri);
  EXPECT_EQ(treat_.state()->guidance.state, guidance::State::lost);
}

TEST_F(TreatReturn, ACheckIsAskedForAfterItsTime) {
  testing::ChangedSettings<monitoring::RegistrationCheckRules> rules;
  rules->ask_after_min = 0.005;
  open();
  return_.beginNew();
  treat_.align(true);
  settle();
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.isRunning(); }));
  EXPECT_TRUE(reads("CHECK THE REGISTRATION"));
  EXPECT_EQ(check_.level(), Level::caution);
  rules->ask_after_min = 20;
  check_.begin();
  EXPECT_TRUE(reads("Registration passed"));
}

TEST_F(TreatReturn, ThePageOffersBothChoicesAndTheKeyKChecks) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto case_folder = plannedCase(folder_.path(), true);
  writeCutSession(case_folder);
  MainWindow window(services_);
  window.show();
  window.resize(1366, 768);
  window.openCase(QString::fromStdString(case_folder.string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }));
  window.setWorkspace(Workspace::treat);
  window.findChild<TreatWorkspace*>()->presenter().openRecording(
      QString::fromStdString(writeRecording(folder_.path(), 3000).string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().hasRecording(); }));
  const auto take = [&](const char* name) {
    if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
      window.grab().save(QString("%1/%2.png").arg(pictures, name));
  };
  QPushButton *go_on = nullptr, *begin_new = nullptr;
  for (auto* button : window.findChildren<QPushButton*>()) {
    if (button->text() == "Go on with it") go_on = button;
    if (button->text() == "Begin a new one") begin_new = button;
  }
  ASSERT_TRUE(go_on && begin_new);
  EXPECT_TRUE(
      fixtures::waitFor([&] { return go_on->isVisible() && go_on->isEnabled() && begin_new->isVisible(); }));
  take("return_offered_1366");
  QTest::mouseClick(go_on, Qt::LeftButton);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }));
  ASSERT_TRUE(fixtures::waitFor([&] { return bool(window.treat().state()->camera_T_mri); }));
  EXPECT_TRUE(fixtures::waitFor([&] { return !go_on->isVisible(); }));
  const auto* words = window.findChild<QLabel*>("check_words");
  EXPECT_TRUE(fixtures::waitFor([&] { return words->text().contains("Registration passed"); }))
      << words->text().toStdString();
  take("check_passed_1366");
  *verdict_ = Verdict::drifted;
  QApplication::setActiveWindow(&window);
  QTest::keyClick(&window, Qt::Key_K);
  EXPECT_TRUE(fixtures::waitFor([&] { return words->text().contains("REGISTRATION FAILED"); }));
  fixtures::layOut();
  EXPECT_EQ(window.size(), QSize(1366, 768)) << "no words widen the window";
  take("check_failed_1366");
}

}  // namespace
}  // namespace facenav::ui
