// Hotspot and threshold, answers and notes in Treat, without a window.

#include "treat/motor_presenter.h"

#include <gtest/gtest.h>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/twitches.h"
#include "treat/session_sounds.h"
#include "treat_fixtures.h"

namespace facenav::ui {
namespace {

using namespace treat_fixtures;

class MotorPresenterTest : public ::testing::Test {
 protected:
  MotorPresenterTest()
      : services_(fakeServices()), treat_(services_, model_, tasks_), motor_(treat_, model_) {
    QObject::connect(&treat_, &TreatPresenter::refused, [this](const QString& words) { refused_ = words; });
    QObject::connect(&motor_, &MotorPresenter::refused, [this](const QString& words) { refused_ = words; });
    treat_.setPulseSource("");
  }
  void guide() {
    case_folder_ = plannedCase(folder_.path(), true);
    TaskMonitor monitor;
    model_.open(loadCase(case_folder_, monitor));
    treat_.openRecording(QString::fromStdString(writeRecording(folder_.path(), 1500).string()));
    settle();
    treat_.align(true);
    ASSERT_TRUE(fixtures::waitFor([&] { return treat_.isRunning(); }));
    ASSERT_TRUE(fixtures::waitFor([&] { return treat_.state()->frame > 1; }));
  }
  void settle() {
    fixtures::waitFor([&] { return !tasks_.isRunning(); });
  }
  void pulse() {
    const int before = treat_.pulses();
    fixtures::waitFor([] { return false; }, 160);  // past the key's dead time
    treat_.countPulse();
    ASSERT_TRUE(fixtures::waitFor([&] { return treat_.pulses() == before + 1; }));
  }
  casefile::KeptSession kept() const {
    return casefile::readSession(casefile::findSession(case_folder_, ""));
  }

  testing::TemporaryFolder folder_;
  Services services_;
  CaseModel model_;
  TaskRunner tasks_;
  TreatPresenter treat_;
  MotorPresenter motor_;
  std::filesystem::path case_folder_;
  QString refused_;
};

TEST_F(MotorPresenterTest, EachAnswerIsKeptWithItsPulseAndMovesTheSearch) {
  guide();
  motor_.answer(true);
  EXPECT_FALSE(refused_.isEmpty()) << "there is no pulse yet";
  motor_.search(stimulation::ThresholdMethod::bayes, "FDI");
  ASSERT_TRUE(motor_.isSearching());
  EXPECT_DOUBLE_EQ(treat_.intensity().value(), 52) << "the search says what to set";
  EXPECT_TRUE(motor_.thresholdWords().startsWith("set the output to 52 %"));
  pulse();
  motor_.answer(true);
  const double second_pct = treat_.intensity().value();
  EXPECT_LT(second_pct, 52);
  pulse();
  motor_.answerWithMep(12);
  EXPECT_GT(treat_.intensity().value(), second_pct);
  EXPECT_EQ(motor_.state()->pulses, 2);
  motor_.takeBack();
  EXPECT_DOUBLE_EQ(treat_.intensity().value(), second_pct);
  treat_.end();
  const auto session = kept();
  ASSERT_EQ(session.pulses.pulses.size(), 2u);
  EXPECT_DOUBLE_EQ(session.pulses.pulses[0].pulse.intensity_pct.value(), 52);
  EXPECT_DOUBLE_EQ(session.pulses.pulses[1].pulse.intensity_pct.value(), second_pct);
  EXPECT_DOUBLE_EQ(session.pulses.pulses[1].pulse.mep_uv.value(), 12);
  EXPECT_EQ(casefile::readTwitches(session.folder), (std::map<int, bool>{{1, true}}));
  MotorPresenter again(treat_, model_);
  again.search(stimulation::ThresholdMethod::bayes, "");
  EXPECT_EQ(again.state()->pulses, 1) << "gone on with in the next session";
}

TEST_F(MotorPresenterTest, AKeyWithoutAPulseIsNoAnswerAndTheQuestionNamesThePulse) {
  guide();
  motor_.search(stimulation::ThresholdMethod::bayes, "FDI");
  EXPECT_TRUE(motor_.question().startsWith("No pulse to answer for")) << motor_.question().toStdString();
  EXPECT_FALSE(motor_.canAnswer());
  motor_.answer(true);
  EXPECT_EQ(motor_.state()->pulses, 0);
  pulse();
  EXPECT_TRUE(motor_.question().startsWith("Pulse 1 at 52 %: did the muscle move?"))
      << motor_.question().toStdString();
  treat_.setIntensity(70.0);  // for the next pulse, typed before the answer
  motor_.answer(true);
  const double next_pct = treat_.intensity().value();
  refused_.clear();
  for (int bounce = 0; bounce < 2; ++bounce) {
    motor_.answer(true);
    motor_.answer(false);
  }
  EXPECT_EQ(motor_.state()->pulses, 1) << "one answer a pulse";
  EXPECT_DOUBLE_EQ(treat_.intensity().value(), next_pct) << "the proposal has not moved";
  EXPECT_TRUE(refused_.startsWith("Pulse 1 is answered")) << refused_.toStdString();
  ASSERT_TRUE(motor_.canTakeBack());
  motor_.takeBack();
  EXPECT_EQ(motor_.state()->pulses, 0);
  EXPECT_TRUE(motor_.canAnswer()) << "the pulse can be answered again";
  motor_.answer(false);
  EXPECT_EQ(motor_.state()->pulses, 1);
  EXPECT_GT(treat_.intensity().value(), 52);
  treat_.end();
  EXPECT_EQ(casefile::readTwitches(kept().folder), (std::map<int, bool>{{1, false}}));
}

TEST_F(MotorPresenterTest, APulseFromBeforeTheSearchIsNoneOfIts) {
  guide();
  treat_.setIntensity(80.0);
  pulse();
  motor_.search(stimulation::ThresholdMethod::bayes, "FDI");
  motor_.answer(true);
  EXPECT_EQ(motor_.state()->pulses, 0);
  EXPECT_EQ(motor_.question().left(19), "Pulse 1 is answered") << "it is kept with its pulse all the same";
}

TEST_F(MotorPresenterTest, AHuntGuidesFromSiteToSiteAndBackToTheTarget) {
  guide();
  const std::string target = treat_.target()->name;
  motor_.hunt();
  ASSERT_TRUE(motor_.isHunting());
  EXPECT_TRUE(motor_.siteWords().startsWith("site 1 of ")) << motor_.siteWords().toStdString();
  const auto first = treat_.target()->mri_T_target.translation_mm();
  motor_.nextSite();
  EXPECT_GT((treat_.target()->mri_T_target.translation_mm() - first).norm(), 5.0);
  ASSERT_TRUE(fixtures::waitFor([&] { return treat_.state()->target == treat_.target()->name; }));
  pulse();
  EXPECT_EQ(treat_.pulseCounts().outside, 1) << "the coil still lies at the first site";
  ASSERT_TRUE(treat_.lastPulse());
  EXPECT_FALSE(treat_.lastPulse()->reason.empty());
  const std::string site = treat_.target()->name;
  motor_.endHunt();
  EXPECT_EQ(treat_.target()->name, target);
  EXPECT_EQ(model_.current().plan.targets.size(), 1u) << "sites are not targets of the plan";
  treat_.end();
  EXPECT_EQ(kept().pulses.pulses[0].pulse.target->name, site);
}

TEST_F(MotorPresenterTest, ChoosingATargetEndsTheHunt) {
  guide();
  motor_.hunt();
  treat_.chooseTarget("spot");
  EXPECT_FALSE(motor_.isHunting());
}

TEST_F(MotorPresenterTest, NotesPausesAndASourceAreEventsAndPainMayFollowTheEnd) {
  EXPECT_FALSE(treat_.note("pain before", "6")) << "no session yet";
  guide();
  EXPECT_TRUE(treat_.note("pain before", "6"));
  EXPECT_FALSE(treat_.note("adverse event", "  "));
  treat_.pause("coil too warm");
  EXPECT_TRUE(treat_.isPaused());
  treat_.resume();
  EXPECT_FALSE(treat_.setPulseSource("usb:1")) << "unknown words change nothing";
  EXPECT_TRUE(treat_.setPulseSource("udp:127.0.0.1:38912"));
  EXPECT_TRUE(treat_.setPulseSource(""));
  treat_.end();
  EXPECT_TRUE(treat_.note("pain after", "2"));
  std::string events;
  for (const auto& event : kept().events) events += event.event + "=" + event.detail + ";";
  for (const char* words :
       {"pain before=6;", "pause=coil too warm;", "resume=;", "listening;", "pain after=2;"})
    EXPECT_NE(events.find(words), std::string::npos) << words << " in " << events;
}

TEST(SessionSounds, ATonePerChangeAndNoneInBetween) {
  using sounds::Tone;
  const auto between = toneBetween;
  EXPECT_EQ(between(Nearness::far, Nearness::near), Tone::approaching);
  EXPECT_EQ(between(Nearness::near, Nearness::on_target), Tone::on_target);
  EXPECT_EQ(between(Nearness::on_target, Nearness::near), Tone::approaching) << "just left";
  EXPECT_EQ(between(Nearness::on_target, Nearness::lost), Tone::lost);
  EXPECT_EQ(between(Nearness::lost, Nearness::far), std::nullopt);
  for (const auto same : {Nearness::lost, Nearness::far, Nearness::near, Nearness::on_target})
    EXPECT_EQ(between(same, same), std::nullopt);
}

TEST(SessionSounds, NearIsWithinTenMillimetres) {
  guidance::GuidanceState state;
  EXPECT_EQ(nearnessOf(state), Nearness::lost);
  state.state = guidance::State::adjust;
  state.values = guidance::GuidanceValues{};
  state.values->distance_mm = 9.9;
  EXPECT_EQ(nearnessOf(state), Nearness::near);
  state.values->distance_mm = 10.1;
  EXPECT_EQ(nearnessOf(state), Nearness::far);
  state.state = guidance::State::on_target;
  EXPECT_EQ(nearnessOf(state), Nearness::on_target);
}

}  // namespace
}  // namespace facenav::ui
