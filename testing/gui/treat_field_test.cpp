// The live electric field in Treat: of the coil as it is held, gone with its pose, remembered; the dose by
// field beside the motor threshold; the field of each pulse. FACENAV_GUI_PICTURES=DIR keeps an image.

#include <gmock/gmock.h>

#include <QLabel>
#include <QPushButton>
#include <cstdlib>
#include <utility>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/threshold_file.h"
#include "facenav/core/whole_file.h"
#include "facenav/efield/built_in_coils.h"
#include "facenav/scene/display.h"
#include "plan/field_presenter.h"
#include "shell/colour_legend.h"
#include "shell/scene_view.h"
#include "support/window_checks.h"
#include "treat/live_field_view.h"
#include "treat/motor_panel.h"
#include "treat/treat_workspace.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;
using ::testing::HasSubstr;

/// A ball with a brain, and a session with the coil at its target.
class TreatField : public ::testing::Test {
 protected:
  TreatField() : services_(fakeServices()), treat_(services_, model_, tasks_) {
    QSettings().clear();
    treat_.setPulseSource("");
    case_folder_ = folder_.path() / "case";
    const auto store = casefile::CaseStore::create(case_folder_, fixtures::ballWithBrain(), {}, false);
    guidance::TreatmentPlan plan;
    plan.targets.push_back(fakes::targetAt(kMarker.reframe<Camera, Coil>()).target);
    store.setTargets(plan);
    casefile::signOff(store, {"XY", "", true});
  }
  ~TreatField() override { QSettings().clear(); }
  void guide() {
    TaskMonitor monitor;
    model_.open(loadCase(case_folder_, monitor));
    treat_.openRecording(QString::fromStdString(writeRecording(folder_.path(), 3000).string()));
    settle();
    treat_.align(true);
    ASSERT_TRUE(fixtures::waitFor([&] { return treat_.isRunning(); }));
    ASSERT_TRUE(fixtures::waitFor([&] { return treat_.state()->frame > 1; }));
  }
  void settle() {
    fixtures::waitFor([&] { return !tasks_.isRunning(); });
  }
  bool waitForField(LiveFieldPresenter& field) {
    return fixtures::waitFor([&] {
      field.follow(*treat_.state());
      return field.shown() != nullptr;
    });
  }
  /// A finished search at the target, with a threshold of about 48 %.
  void keepThreshold() const {
    auto file =
        casefile::ThresholdFile::begin(case_folder_, stimulation::ThresholdMethod::bayes, "FDI",
                                       casefile::CaseStore::open(case_folder_).targets().targets.front());
    auto state = thresholdAfter(stimulation::ThresholdMethod::bayes, {});
    while (!state.isDone()) {
      file.keep({{*state.next_pct, *state.next_pct >= 48}});
      state = thresholdAfter(stimulation::ThresholdMethod::bayes, file.kept().plain());
    }
  }

  testing::TemporaryFolder folder_;
  std::filesystem::path case_folder_;
  Services services_;
  CaseModel model_;
  TaskRunner tasks_;
  TreatPresenter treat_;
};

TEST_F(TreatField, ItIsThatOfTheHeldCoilAndGoesWithItsPose) {
  guide();
  LiveFieldPresenter field(treat_, model_);
  EXPECT_FALSE(field.isOn()) << "off at first";
  field.readChoices();
  field.setOn(true);
  ASSERT_TRUE(waitForField(field)) << field.words().toStdString();
  const steps::ReadHead head(model_.current().store);
  const auto pose = steps::coilPoseOf(*treat_.target());
  const double known =
      head.near(pose)
          ->at(efield::figureEight70(), pose, Eigen::Matrix3Xd(treat_.target()->cortex_point.mm))
          .norm();
  EXPECT_NEAR(*field.shown()->at_target, known, 1e-4 * known) << "the coil is at its target";
  EXPECT_THAT(field.words().toStdString(), HasSubstr("E at target " + strengthFigure(known).toStdString()));
  EXPECT_THAT(field.words().toStdString(), HasSubstr("at 1 A/us, as set in Plan"));
  EXPECT_THAT(field.words().toStdString(), HasSubstr("tier 0: a local sphere, usual error 28 %"));
  EXPECT_TRUE(fixtures::waitFor([&] {
    field.follow(*treat_.state());
    return field.words().contains(", 100 % of the planned pose");
  })) << field.words().toStdString();
  EXPECT_TRUE(field.picture());
  field.follow(session::blanked(*treat_.state(), LostReason::no_face));
  EXPECT_EQ(field.shown(), nullptr);
  EXPECT_FALSE(field.picture());
  EXPECT_THAT(field.words().toStdString(), HasSubstr("no field: the pose of head or coil is not known"));
  ASSERT_TRUE(waitForField(field)) << "it comes back with the pose";
  const int asked = field.computed();
  EXPECT_TRUE(fixtures::waitFor([&] { return field.computed() >= asked + 10; })) << "without being asked for";
  field.rest();
  EXPECT_EQ(field.shown(), nullptr) << "the page is hidden";
  int rested = field.computed();
  EXPECT_TRUE(fixtures::waitFor([&] {
    const int before = std::exchange(rested, field.computed());
    fixtures::waitFor([] { return false; }, 200);
    return before == rested && field.computed() == rested;
  })) << "what was on its way is over, and nothing follows";
  ASSERT_TRUE(waitForField(field));
  treat_.pause("coil too warm");
  field.follow(*treat_.state());
  EXPECT_FALSE(field.picture());
  EXPECT_THAT(field.words().toStdString(), HasSubstr("in a pause"));
  const LiveFieldPresenter next(treat_, model_);
  EXPECT_TRUE(next.isOn()) << "remembered";
  field.setOn(false);
  EXPECT_EQ(field.words(), "");
}

TEST_F(TreatField, TheShareOfTheThresholdAndTheDoseFollowFromTheHotspot) {
  keepThreshold();
  guide();
  LiveFieldPresenter field(treat_, model_);
  field.readChoices();
  ASSERT_TRUE(fixtures::waitFor([&] {
    field.follow(*treat_.state());
    return !field.doseInWords().isEmpty();
  })) << "also while the field is not shown";
  EXPECT_THAT(
      field.doseInWords().toStdString(),
      HasSubstr("% of the output gives this target the field that spot had at its threshold of 48 %"));
  field.setOn(true);
  treat_.setIntensity(57.0);
  ASSERT_TRUE(waitForField(field));
  EXPECT_TRUE(fixtures::waitFor([&] {
    field.follow(*treat_.state());
    return field.words().contains("% of the motor threshold");
  })) << field.words().toStdString();
}

TEST_F(TreatField, EachPulseKeepsItsField) {
  guide();
  treat_.countPulse();
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.pulses() == 1; }));
  bool has_ended = false;
  QObject::connect(&treat_, &TreatPresenter::sessionEnded, [&] { has_ended = true; });
  treat_.end();
  ASSERT_TRUE(fixtures::waitFor([&] { return has_ended; }));
  const auto session = casefile::readSession(casefile::findSession(case_folder_, ""));
  ASSERT_EQ(session.pulses.pulses.size(), 1u);
  const auto& pulse = session.pulses.pulses[0].pulse;
  ASSERT_TRUE(pulse.field);
  EXPECT_EQ(pulse.field->tier, 0);
  EXPECT_GT(*pulse.field->at_target, 0);
  const std::string report = readWholeFile(session.folder / "report.html");
  EXPECT_THAT(report, HasSubstr("Electric field"));
  EXPECT_THAT(report, HasSubstr("tier 0: a sphere fitted to the skull under the coil"));
}

TEST_F(TreatField, ThePageColoursTheBrainAndSaysTheDose) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  keepThreshold();
  TreatWorkspace page(treat_, model_);
  page.resize(1366, 768);
  page.show();
  guide();
  auto* view = page.findChild<LiveFieldView*>();
  EXPECT_FALSE(view->isVisible());
  for (auto* button : page.findChildren<QPushButton*>())
    if (button->text() == "Field") button->click();
  ASSERT_TRUE(fixtures::waitFor([&] { return page.field().picture().has_value(); }));
  EXPECT_TRUE(view->isVisible());
  EXPECT_TRUE(
      fixtures::waitFor([&] { return view->findChild<ColourLegend*>()->words().startsWith("|E|, tier 0"); }));
  auto* dose = page.findChild<MotorPanel*>()->findChild<QLabel*>("dose");
  EXPECT_TRUE(fixtures::waitFor([&] { return dose->text().contains("dose by field"); }));
  EXPECT_TRUE(fixtures::waitFor([&] { return testing::cutTexts(*view).isEmpty(); }))
      << testing::cutTexts(*view).join('\n').toStdString();
  auto* words = view->findChild<QLabel*>("muted");
  EXPECT_GE(words->height(), words->heightForWidth(words->width()));
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
    page.grab().save(QString("%1/treat_field.png").arg(pictures));
  treat_.pause("coil too warm");
  EXPECT_TRUE(fixtures::waitFor([&] { return !page.field().picture(); }));
}

}  // namespace
}  // namespace facenav::ui
