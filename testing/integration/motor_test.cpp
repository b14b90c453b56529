// The motor threshold, the hotspot and the notes from the command line, as a person or a program uses them.

#include <gmock/gmock.h>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/pulse_file.h"
#include "facenav/casefile/session_log.h"
#include "facenav/casefile/threshold_file.h"
#include "facenav/casefile/twitches.h"
#include "support/ball_case.h"
#include "support/command_line.h"
#include "support/conversation.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class Motor : public ::testing::Test {
 protected:
  void SetUp() override {
    ::signal(SIGPIPE, SIG_IGN);
    casefile::CaseStore::create(case_, ballWithBrain(), {}, false);
  }
  std::string atCase() const { return "'" + case_.string() + "'"; }
  TemporaryFolder folder_;
  fs::path case_ = folder_.path() / "case";
};

TEST_F(Motor, AProgramFindsTheThresholdOverJsonLines) {
  Conversation facenav({"threshold", case_.string(), "--json", "--muscle", "FDI right"});
  auto state = facenav.hear();
  EXPECT_EQ(state["next_pct"], 52);
  for (int pulse = 1; !state["done"].get<bool>(); ++pulse) {
    const double intensity_pct = state["next_pct"];
    facenav.say(nlohmann::json{{"response", intensity_pct >= 61}, {"intensity_pct", intensity_pct}}.dump());
    state = facenav.hear();
    ASSERT_EQ(state["pulses"], pulse);
    ASSERT_LE(pulse, 20);
  }
  EXPECT_NEAR(state["estimate_pct"], 60.5, 2);
  EXPECT_EQ(facenav.end(), 0);
  EXPECT_EQ(casefile::readThresholds(case_).front().muscle, "FDI right");
}

TEST_F(Motor, AfterKillNineTheSearchHasEveryAnswerThatWasShown) {
  std::mt19937 random(5);
  std::size_t shown = 0;
  for (int death = 0; death < 6; ++death) {
    Conversation facenav({"threshold", case_.string(), "--json", "--method", "5of10", "--quiet"});
    auto state = facenav.hear();
    ASSERT_EQ(state["pulses"], shown) << "what was shown before the kill is there";
    for (int i = 0; i < 3; ++i) {
      facenav.say(state["next_pct"].get<double>() >= 30 ? "y" : "n");
      state = facenav.hear();
      shown = state["pulses"];
    }
    if (random() % 2 == 0) facenav.say("y");  // perhaps kept, perhaps not
    facenav.kill();
    EXPECT_EQ(facenav.end(), 128 + SIGKILL);
    const auto kept = casefile::readThresholds(case_);
    ASSERT_EQ(kept.size(), 1u) << "one search, gone on with";
    ASSERT_GE(kept[0].answers.size(), shown);
    ASSERT_LE(kept[0].answers.size(), shown + 1);
    shown = kept[0].answers.size();
  }
}

TEST_F(Motor, APersonIsAskedInWordsAndAWrongLineChangesNothing) {
  const fs::path answers = folder_.path() / "answers";
  std::ofstream(answers) << "y\n120 uV @ 48\nwhat?\n52\ny @ 130\nundo\nn\nquit\n";
  const auto result = runProgram(
      "/bin/sh", "-c \"'" FACENAV_CLI "' threshold '" + case_.string() + "' < '" + answers.string() + "'\"");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("next: 52 % of the output"));
  EXPECT_THAT(result.output, HasSubstr("2 responses of 2 pulses"));
  EXPECT_THAT(result.errors, HasSubstr("not understood: 'what?'"));
  EXPECT_THAT(result.errors, HasSubstr("not understood: '52'")) << "an output or an MEP?";
  EXPECT_THAT(result.errors, HasSubstr("130 % is not possible"));
  EXPECT_THAT(result.errors, HasSubstr("not finished, 2 answers are kept"));
  EXPECT_EQ(runFacenav("threshold " + atCase() + " --method guess").status, 2);
  EXPECT_EQ(runFacenav("threshold '" + (folder_.path() / "nowhere").string() + "'").status, 1);
}

/// Makes a session whose pulses evoke a response if the coil is near the first target.
fs::path treat(const fs::path& case_folder) {
  casefile::SessionLog log(case_folder);
  log.addEvent("session started");
  casefile::PulseFile pulses(log.folder());
  for (int i = 1; i <= 10; ++i) {
    auto pulse = casefile::madePulse(i);
    const double z_mm = 90, angle = 0.05 * i;
    const RigidTransform<Mri, Coil> mri_T_coil(
        Eigen::Quaterniond(Eigen::AngleAxisd(M_PI + angle, Eigen::Vector3d::UnitY())),
        {z_mm * std::sin(angle), 0, z_mm * std::cos(angle)});
    pulse.camera_T_coil = *pulse.camera_T_mri * mri_T_coil;
    pulse.intensity_pct = 50 + i;
    pulses.keep(pulse);
  }
  std::vector<casefile::MepEdit> meps;
  for (int i = 1; i <= 10; ++i) meps.push_back({i, i == 4 ? 800.0 : 10.0, {}, "typed", ""});
  casefile::editMeps(log.folder(), meps);
  return log.folder();
}

TEST_F(Motor, HotspotAndThresholdComeFromASessionsPulses) {
  EXPECT_EQ(runFacenav("hotspot " + atCase()).status, 1) << "no session";
  treat(case_);
  const auto spot = runFacenav("hotspot " + atCase() + " --json");
  ASSERT_EQ(spot.status, 0) << spot.errors;
  const auto json = nlohmann::json::parse(spot.output);
  EXPECT_EQ(json["pulses"], 10);
  EXPECT_EQ(json["responses"], 1);
  EXPECT_EQ(json["largest_pulse"], 4);
  EXPECT_NEAR(json["peak_mm"][0].get<double>(), 40 * std::sin(0.2), 3.0);
  EXPECT_THAT(runFacenav("hotspot " + atCase()).output, HasSubstr("sigma"));
  const auto threshold = runFacenav("threshold " + atCase() + " --session '' --json");
  ASSERT_EQ(threshold.status, 0) << threshold.errors;
  EXPECT_EQ(nlohmann::json::parse(threshold.output)["responses"], 1);
}

TEST_F(Motor, NotesStandAmongTheEventsAndInTheReport) {
  const fs::path session = treat(case_);
  EXPECT_EQ(runFacenav("note " + atCase()).status, 2) << "nothing to note";
  EXPECT_EQ(runFacenav("note " + atCase() + " --pain-before 11").status, 2);
  ASSERT_EQ(
      runFacenav("note " + atCase() + " --pain-before 6 --pain-after 3.5 --adverse-event 'mild headache'")
          .status,
      0);
  const auto kept = casefile::readSession(session);
  ASSERT_EQ(kept.events.size(), 4u);
  EXPECT_EQ(kept.events[1].event, "pain before");
  EXPECT_EQ(kept.events[2].detail, "3.5");
  ASSERT_EQ(runFacenav("report " + atCase()).status, 0);
  EXPECT_THAT(readText(session / "report.html"), HasSubstr("mild headache"));
  EXPECT_THAT(runFacenav("sessions " + atCase() + " --json").output, HasSubstr("\"adverse_events\": 1"));
}

}  // namespace
}  // namespace facenav::testing
