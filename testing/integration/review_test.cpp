// A scripted session (fake cameras and trackers) through the session loop and its log, then the command
// line's output about it: sessions, pulses, exclusions, report.

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include "facenav/casefile/kept_session.h"
#include "facenav/core/csv_table.h"
#include "facenav/dicom/series.h"
#include "facenav/session/treatment_log.h"
#include "support/ball_case.h"
#include "support/command_line.h"
#include "support/made_xdf.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
namespace fakes = session::fakes;
using ::testing::HasSubstr;
using ::testing::Not;

const RigidTransform<Camera, Marker> kMarker(Eigen::Quaterniond::Identity(), {20, -60, 550});
constexpr int kFrames = 150, kLostFrom = 100;  // at 50 frames a second; the face is lost from kLostFrom on

/// Gives twelve pulses in the first part and three after the face is lost, each from a source of its own.
/// Returns the session's folder.
fs::path treat(const fs::path& case_folder) {
  auto navigator = std::make_unique<session::Navigator>(
      fakes::setup(), std::make_unique<fakes::Head>([](std::int64_t n) {
        return n >= kLostFrom ? std::nullopt : std::optional(RigidTransform<Camera, Head>());
      }),
      std::make_unique<fakes::Coil>(kMarker));
  navigator->setTarget(fakes::targetAt(kMarker.reframe<Camera, Coil>()));
  auto running = std::make_shared<session::Session>(std::make_unique<fakes::Source>(kFrames, 0.02),
                                                    std::move(navigator), session::SessionOptions{});
  session::TreatmentLog log(running, case_folder);
  log.addEvent("coil", "figure-8 70 mm");
  running->start();
  const auto waitForFrame = [&](std::int64_t frame) {
    while (running->latest()->frame < frame) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  waitForFrame(2);
  for (int i = 0; i < 12; ++i) {
    log.addPulse({"pedal " + std::to_string(i)});
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  log.addPulse({"pedal 11"});  // a bounce
  waitForFrame(kLostFrom + 2);
  for (int i = 12; i < 15; ++i) log.addPulse({"pedal " + std::to_string(i)});
  while (!running->hasEnded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return log.folder();
}

class Review : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!made_) makeSession();
    fs::copy(made_->path() / "case", case_, fs::copy_options::recursive);
    session_ = casefile::findSession(case_, "");
  }
  static void TearDownTestSuite() { made_.reset(); }
  /// Plays the session of three seconds, once for all tests.
  static void makeSession() {
    made_ = std::make_unique<TemporaryFolder>();
    casefile::CaseStore::create(made_->path() / "case", ballCase(), {}, false).setLabel("Jane Doe");
    treat(made_->path() / "case");
  }
  CommandResult run(const std::string& words) const { return runFacenav(words); }
  static inline std::unique_ptr<TemporaryFolder> made_;
  TemporaryFolder folder_;
  fs::path case_ = folder_.path() / "case", session_;
};

TEST_F(Review, SessionPulsesExclusionsAndReportFromTheCommandLine) {
  const std::string at_case = "'" + case_.string() + "'", name = session_.filename().string();
  const auto list = run("sessions " + at_case);
  ASSERT_EQ(list.status, 0) << list.errors;
  EXPECT_THAT(list.output, HasSubstr(name));
  const auto json = run("sessions " + at_case + " --json");
  for (const char* words : {"\"pulses\": 15", "\"on_target\": 12", "\"lost\": 3", "\"double_triggers\": 1",
                            "\"face_losses\": 1", "\"has_ended\": true"})
    EXPECT_THAT(json.output, HasSubstr(words));

  const fs::path csv = folder_.path() / "pulses.csv";
  const auto pulses = run("pulses " + at_case + " " + name + " -o '" + csv.string() + "'");
  ASSERT_EQ(pulses.status, 0) << pulses.errors;
  const CsvTable table(csv);
  ASSERT_EQ(table.rows(), 15u);
  const auto wanted = fakes::targetAt(kMarker.reframe<Camera, Coil>()).target.mri_T_target;
  EXPECT_NEAR(table.number(0, table.column("tx")), wanted.translation_mm().x(), 1e-3);
  EXPECT_EQ(table.text(14, table.column("status")), "lost");
  EXPECT_EQ(table.text(14, table.column("reason")), "face not seen");
  EXPECT_THAT(run("pulses " + at_case).output, Not(HasSubstr("moved")));

  EXPECT_EQ(run("pulses " + at_case + " --exclude 3 --exclude 4 --reason 'coil moved' --by AB").status, 0);
  EXPECT_EQ(run("pulses " + at_case + " --include 4").status, 0);
  const auto shown = run("pulses " + at_case);
  EXPECT_THAT(shown.output, HasSubstr(",1,coil moved,"));
  EXPECT_EQ(std::count(shown.output.begin(), shown.output.end(), '\n'), 16) << "no pulse was deleted";
  EXPECT_THAT(run("pulses " + at_case + " --json").output, HasSubstr("\"note\": \"coil moved\""));
  EXPECT_EQ(run("pulses " + at_case + " --exclude 99 --reason why").status, 1);
  EXPECT_EQ(run("pulses " + at_case + " --exclude 5").status, 2) << "without a reason";

  const fs::path page = folder_.path() / "report.html";
  ASSERT_EQ(run("report " + at_case + " -o '" + page.string() + "'").status, 0);
  EXPECT_THAT(readText(page), HasSubstr("coil moved"));
  EXPECT_THAT(readText(page), HasSubstr("figure-8 70 mm"));
  EXPECT_THAT(readText(page), Not(HasSubstr("Jane")));
  ASSERT_EQ(run("report " + at_case + " " + name + " --with-name").status, 0);
  EXPECT_THAT(readText(session_ / "report.html"), HasSubstr("Jane Doe"));
}

TEST_F(Review, MepsByTimeTypedOrMeasuredAreKeptAndRefusedWhereTheyCannotBe) {
  const std::string pulses = "pulses '" + case_.string() + "' ";
  const fs::path csv = folder_.path() / "emg.csv";
  {
    const auto session = casefile::readSessionPulses(session_);
    std::ofstream file(csv);
    file << "t_s,mep_uv\n";
    for (int i : {0, 5}) file << *session.pulses[std::size_t(i)].pulse.t_s + 60.0 << "," << 100 + i << "\n";
  }
  const auto unclear = run(pulses + "--mep '" + csv.string() + "'");
  EXPECT_EQ(unclear.status, 1) << "two rows do not tell the offset of the clocks";
  EXPECT_EQ(std::count(unclear.errors.begin(), unclear.errors.end(), '\n'), 1) << unclear.errors;
  EXPECT_FALSE(fs::exists(session_ / "pulse_edits.jsonl"));
  const auto typed = run(pulses + "--set-mep 2=350 --by AB");
  EXPECT_EQ(typed.status, 0) << typed.errors;
  EXPECT_EQ(casefile::readSessionPulses(session_).pulses[1].pulse.mep_uv, 350);
  EXPECT_EQ(run(pulses + "--set-mep 2=").status, 0);
  EXPECT_FALSE(casefile::readSessionPulses(session_).pulses[1].pulse.mep_uv);
  for (const char* wrong : {"2:350", "two=350", "2=nan", "2=1e30"})
    EXPECT_EQ(run(pulses + "--set-mep " + wrong).status, 2) << wrong;
  for (const char* absent : {"99=350", "2=-4"})
    EXPECT_EQ(run(pulses + "--set-mep " + absent).status, 1) << absent;

  // Measured from a recording of LSL streams.
  const auto session = casefile::readSessionPulses(session_);
  // 20 ms apart: 0.19 s before the first and after the twelfth, only one is within 0.2 s.
  const double first_s = *session.pulses[0].pulse.t_s - 0.19, last_s = *session.pulses[11].pulse.t_s + 0.19;
  const fs::path xdf = folder_.path() / "emg.xdf";
  std::ofstream(xdf, std::ios::binary) << twoPulsesXdf(first_s + 60, last_s + 60);
  const std::string mep = pulses + "--mep '" + xdf.string() + "' ";
  const auto other = run(mep + "--markers Other --offset=-60");
  EXPECT_EQ(other.status, 1);
  EXPECT_EQ(std::count(other.errors.begin(), other.errors.end(), '\n'), 1) << other.errors;
  EXPECT_EQ(run(mep + "--emg-unit inch").status, 2);
  const auto taken = run(mep + "--emg Amplifier:FDI --markers Pulses:T --offset=-60");
  EXPECT_EQ(taken.status, 0) << taken.errors;
  EXPECT_THAT(taken.output, HasSubstr("2 MEPs from emg.xdf"));
  EXPECT_THAT(taken.errors, HasSubstr("15 to 50 ms after the 2 markers"));
  for (const std::size_t pulse : {0, 11})
    EXPECT_EQ(casefile::readSessionPulses(session_).pulses[pulse].pulse.mep_uv, 120);
  std::ofstream(xdf, std::ios::binary) << "XDF:broken";
  EXPECT_EQ(run(mep).status, 1);
}

TEST_F(Review, TwoSessionsAreComparedByTheirMeanCoilPose) {
  const fs::path second = treat(case_);
  const auto compared = run("sessions '" + case_.string() + "' --compare " + session_.filename().string() +
                            " " + second.filename().string() + " --json");
  ASSERT_EQ(compared.status, 0) << compared.errors;
  EXPECT_THAT(compared.output, HasSubstr("\"pulses\": 12"));
  const auto at = compared.output.find("\"distance_mm\": ");
  ASSERT_NE(at, std::string::npos) << compared.output;
  EXPECT_LT(std::stod(compared.output.substr(at + 15)), 1e-6) << "the coil stood still in both";
  EXPECT_EQ(run("sessions '" + case_.string() + "' --compare " + second.filename().string()).status, 2);
}

TEST_F(Review, TheReportIsAlsoAPdf) {
  if (!fs::exists(fs::path(FACENAV_CLI).parent_path() / "facenav-gui"))
    GTEST_SKIP() << "built without the window";
  const fs::path page = folder_.path() / "page.html", pdf = folder_.path() / "page.pdf";
  const fs::path object = folder_.path() / "page.dcm", source = folder_.path() / "dicom";
  dicom::writeSeries(ballCase().mri, source, {});
  const auto made = run("report '" + case_.string() + "' --pdf --no-pictures -o '" + page.string() +
                        "' --dicom '" + object.string() + "' --source '" + source.string() + "'");
  ASSERT_EQ(made.status, 0) << made.errors;
  const std::string content = readText(pdf);
  EXPECT_EQ(content.substr(0, 5), "%PDF-");
  EXPECT_GT(content.size(), 20000u) << "with its charts";
  EXPECT_THAT(content, Not(HasSubstr("Jane")));
  const std::string wrapped = readText(object);
  EXPECT_NE(wrapped.find(content), std::string::npos) << "the PDF byte for byte";
  EXPECT_NE(wrapped.find("Virtual^Patient"), std::string::npos) << "the patient of the source";
  EXPECT_EQ(fs::status(object).permissions() & fs::perms::mask,
            fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(fs::status(pdf).permissions() & fs::perms::mask, fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Review, ASessionOrAPatientThatIsNotThereIsOneLineOfError) {
  const std::string report = "report '" + case_.string() + "' --no-pictures ";
  const auto unnamed = run(report + "--dicom '" + (folder_.path() / "a.dcm").string() + "'");
  EXPECT_EQ(unnamed.status, 2);
  EXPECT_THAT(unnamed.errors, HasSubstr("give their folder with --source"));
  EXPECT_EQ(run(report + "--source '" + folder_.path().string() + "'").status, 2);
  const auto missing = run("pulses '" + case_.string() + "' 19990101T000000Z");
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(std::count(missing.errors.begin(), missing.errors.end(), '\n'), 1) << missing.errors;
  EXPECT_THAT(missing.errors, HasSubstr(session_.filename().string())) << "those that exist are named";
}

}  // namespace
}  // namespace facenav::testing
