#include "facenav/treat/treatment.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/casefile/twitches.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/ball_case.h"
#include "support/test_data.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::steps {
namespace {

namespace fs = std::filesystem;
namespace fakes = session::fakes;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

const RigidTransform<Camera, Marker> kMarker(Eigen::Quaterniond::Identity(), {20, -60, 550});

template <class Condition>
bool waitFor(Condition condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(5ms);
  return condition();
}

class TreatmentTest : public ::testing::Test {
 protected:
  TreatmentTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballCase(), {}, false)) {}

  TreatmentRequest request() const {
    auto alignment = std::make_shared<AlignmentOutcome>();
    alignment->result.camera_T_mri = fakes::cameraAtReference();
    capture::Recording recording;
    recording.rig = fakes::rig();
    return {store_, recording, false, coil_tracking::defaultCoil(), alignment};
  }
  static TreatmentDevices devices() {
    return {[](const session::NavigatorSetup& setup) {
              return std::make_unique<session::Navigator>(
                  setup, std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
                  std::make_unique<fakes::Coil>(kMarker));
            },
            [] { return std::make_unique<fakes::Source>(3000, 0.01); }};
  }
  /// Signs off, starts at the target under the coil, and waits for the first pose.
  std::unique_ptr<Treatment> start() {
    casefile::signOff(store_, {"XY", "", true});
    auto treatment = std::make_unique<Treatment>(prepareTreatment(request(), devices()),
                                                 fakes::targetAt(kMarker.reframe<Camera, Coil>()));
    waitFor([&] { return treatment->session().latest()->frame >= 2; });
    return treatment;
  }
  casefile::KeptSession kept() const {
    return casefile::readSession(casefile::findSession(store_.folder(), ""));
  }

  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
};

TEST_F(TreatmentTest, NothingIsOpenedForACaseThatNobodySignedOff) {
  bool has_opened = false;
  TreatmentDevices devices = this->devices();
  devices.openSource = [&]() -> std::unique_ptr<capture::FrameSource> {
    has_opened = true;
    return nullptr;
  };
  EXPECT_THROW(prepareTreatment(request(), devices), Error);
  EXPECT_FALSE(has_opened);
  auto overridden = request();
  overridden.override = {"B. Clinician", "emergency"};
  prepareTreatment(overridden, devices);
  EXPECT_TRUE(has_opened);
}

TEST_F(TreatmentTest, PulsesOfTheKeyAndOfTheNetworkAreKeptWithSourceIntensityAndVerdict) {
  auto treatment = start();
  treatment->setIntensity(60.0);
  treatment->listen(links::openPulseSource("udp:127.0.0.1:38911"));
  treatment->pressPulse();
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(38911);
  ::inet_pton(AF_INET, "127.0.0.1", &to.sin_addr);
  constexpr int kTrain = 40;  // 50 Hz: a keyboard's dead time would swallow most of them
  for (int i = 0; i < kTrain; ++i) {
    const std::string text = i % 2 == 0 ? R"({"pulse": true})" : R"({"pulse": true, "intensity_pct": 71})";
    ::sendto(socket, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
    std::this_thread::sleep_for(20ms);
  }
  ::close(socket);
  ASSERT_TRUE(waitFor([&] { return treatment->log().pulses() == 1 + kTrain; }));
  EXPECT_EQ(treatment->log().counts().on_target, 1 + kTrain);
  EXPECT_EQ(treatment->log().lastPulse()->number, 1 + kTrain);
  treatment->pause("coil too warm");
  treatment->resume();
  treatment->end();
  const auto session = kept();
  ASSERT_EQ(session.pulses.pulses.size(), std::size_t(1 + kTrain));
  EXPECT_EQ(session.pulses.pulses[0].pulse.source, "keyboard");
  for (int i = 1; i <= kTrain; ++i) {
    const auto& pulse = session.pulses.pulses[std::size_t(i)].pulse;
    EXPECT_EQ(pulse.source, "udp:127.0.0.1:38911");
    EXPECT_DOUBLE_EQ(pulse.intensity_pct.value(), i % 2 == 1 ? 60 : 71);
    EXPECT_GT(pulse.steady_s, session.pulses.pulses[std::size_t(i - 1)].pulse.steady_s);
  }
  std::string events;
  for (const auto& event : session.events) events += event.event + ": " + event.detail + "\n";
  EXPECT_THAT(events, HasSubstr("pulse source: udp:127.0.0.1:38911: listening"));
  EXPECT_THAT(events, HasSubstr("pause: coil too warm\nresume: \npause length: 0 s\n"));
  EXPECT_THAT(events, ::testing::Not(HasSubstr("double trigger")));
}

TEST_F(TreatmentTest, TheMusclesAnswersAreKeptWithTheirPulses) {
  auto treatment = start();
  EXPECT_FALSE(treatment->log().answerPulse(120.0)) << "there is no pulse yet";
  treatment->pressPulse();
  EXPECT_TRUE(treatment->log().answerPulse(120.0)) << "though the pulse may not be on the disk yet";
  EXPECT_FALSE(treatment->log().answerPulse(-1.0));
  std::this_thread::sleep_for(160ms);  // past the key's dead time
  treatment->pressPulse();
  EXPECT_TRUE(treatment->log().answerPulse(true));
  treatment->end();
  const auto session = kept();
  ASSERT_EQ(session.pulses.pulses.size(), 2u);
  EXPECT_DOUBLE_EQ(session.pulses.pulses[0].pulse.mep_uv.value(), 120);
  EXPECT_EQ(casefile::readTwitches(session.folder), (std::map<int, bool>{{2, true}}));
}

TEST_F(TreatmentTest, PulsesCountAgainstTheProtocolUnlessTheTargetHasADoseOfItsOwn) {
  casefile::Protocol protocol;
  protocol.name = "M1 10 Hz";
  protocol.dose.pulses = 3000;
  casefile::setProtocol(store_.folder(), protocol);
  auto treatment = start();
  EXPECT_EQ(treatment->plannedPulses(), 3000);
  auto other = fakes::targetAt(kMarker.reframe<Camera, Coil>());
  other.target.dose = guidance::Dose{};
  other.target.dose->pulses = 600;
  treatment->chooseTarget(other, "other");
  EXPECT_EQ(treatment->plannedPulses(), 600);
  treatment->end();
  std::string events;
  for (const auto& event : kept().events) events += event.event + ": " + event.detail + "\n";
  EXPECT_THAT(events, HasSubstr("protocol: M1 10 Hz, version 1: 3000 pulses"));
}

TEST_F(TreatmentTest, WithoutAProtocolThereIsNoGoal) { EXPECT_FALSE(start()->plannedPulses()); }

TEST_F(TreatmentTest, ASourceThatCannotBeOpenedLeavesTheSessionAlone) {
  auto treatment = start();
  EXPECT_THROW(treatment->listen(links::openPulseSource("serial:/dev/facenav-no-such-port")), Error);
  treatment->pressPulse();
  EXPECT_TRUE(waitFor([&] { return treatment->log().pulses() == 1; }));
}

/// Navigator with a check that always finds the face where it was aligned.
std::unique_ptr<session::Navigator> everAgreeing(std::unique_ptr<session::Navigator> navigator) {
  navigator->setCheck(std::make_unique<monitoring::RegistrationCheck>(
      [](const cameras::StereoFrame&, const RigidTransform<Camera, Mri>&) {
        monitoring::DriftFinding finding;
        finding.verdict = monitoring::DriftFinding::Verdict::agrees;
        return finding;
      },
      monitoring::DriftWatchdog::Mode::in_line));
  return navigator;
}

TEST_F(TreatmentTest, WhatAPersonSaysOfTheTipIsKeptAndAWrongOneWithholdsGuidanceForGood) {
  casefile::signOff(store_, {"XY", "", true});
  auto request = this->request();
  request.coil.tip = Point<Coil>(0, 40, 0);
  auto devices = this->devices();
  devices.makeNavigator = [made = devices.makeNavigator](const session::NavigatorSetup& setup) {
    return everAgreeing(made(setup));
  };
  Treatment treatment(prepareTreatment(request, devices), fakes::targetAt(kMarker.reframe<Camera, Coil>()));
  ASSERT_TRUE(waitFor([&] { return treatment.session().latest()->frame >= 2; }));
  casefile::StoredAlignment alignment;
  alignment.camera_T_mri = fakes::cameraAtReference();
  casefile::writeAlignment(alignment, store_.folder() / "alignment.json");
  fs::create_directory(store_.folder() / "alignment_capture");
  const auto check = treatment.makeTipCheck();
  const auto reading = readTip(*treatment.session().latest(), treatment.tip(), *check);
  ASSERT_TRUE(reading);
  const Eigen::Vector3d tip_mm =
      (fakes::cameraAtReference().inverse() * (kMarker.reframe<Camera, Coil>() * treatment.tip())).mm;
  EXPECT_LT((reading->tip.mm - tip_mm).norm(), 1e-9);
  EXPECT_NEAR(reading->off_skin_mm, tip_mm.norm() - 90, 0.5) << "the case's head is a ball of 90 mm";
  treatment.judgeTip(TipVerdict::right, *reading);
  std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(treatment.session().latest()->camera_T_mri);
  treatment.judgeTip(TipVerdict::wrong, *reading);
  EXPECT_TRUE(waitFor([&] { return treatment.session().latest()->withheld.has_value(); }));
  EXPECT_FALSE(treatment.session().latest()->camera_T_mri);
  treatment.checkRegistration();
  ASSERT_TRUE(waitFor([&] { return treatment.session().latest()->check != nullptr; }));
  EXPECT_TRUE(treatment.session().latest()->check->hasPassed());
  EXPECT_THAT(monitoring::bannerOf(*treatment.session().latest()->withheld), HasSubstr("JUDGED WRONG"))
      << "a check compares the face with the alignment itself";
  EXPECT_FALSE(treatment.session().latest()->camera_T_mri);
  EXPECT_FALSE(store_.alignment()) << "no later session starts with it";
  EXPECT_FALSE(fs::exists(store_.folder() / "alignment_capture"));
  EXPECT_FALSE(readTip(*treatment.session().latest(), treatment.tip(), *check)) << "no pose, no tip";
  treatment.end();
  std::string events;
  for (const auto& event : kept().events) events += event.event + ": " + event.detail + "\n";
  EXPECT_THAT(events, HasSubstr("tip check: judged right: " + inWords(*reading)));
  EXPECT_THAT(events, HasSubstr("tip check: judged wrong: " + inWords(*reading)));
}

TEST_F(TreatmentTest, ItsReportFollowsItsEnd) {
  auto treatment = start();
  treatment->end();
  treatment->end();
  treatment->keepReport();
  EXPECT_TRUE(fs::exists(kept().folder / "report.html"));
}

TEST_F(TreatmentTest, TheAlignmentIsSaidWithTheTargetAndWithout) {
  const auto words = alignmentWords(*request().alignment, nullptr);
  EXPECT_EQ(words, "aligned: 0.00 mm rms over 0 points");
  AlignmentOutcome known = *request().alignment;
  known.result.covariance = Matrix6d::Zero();
  known.result.covariance.bottomRightCorner<3, 3>() = 0.09 * Eigen::Matrix3d::Identity();
  known.result.freedom = 1e6;
  const auto target = fakes::targetAt(kMarker.reframe<Camera, Coil>()).target;
  // Three equal axes of 0.3 mm: 95 % of the lengths are within 0.3 times the root of chi square's 7.815.
  EXPECT_NEAR(known.errorBound_mm(target), 0.3 * std::sqrt(7.815), 0.01);
  EXPECT_EQ(alignmentWords(known, &target),
            "aligned: 95 % within 0.8 mm at spot (0.00 mm rms over 0 points)");
  EXPECT_NEAR(chosenTarget(target, &known).error_bound_mm, 0.839, 0.01);
}

TEST_F(TreatmentTest, CautionsOfTheAlignmentAndAnUnaskedEndAreInTheReport) {
  casefile::signOff(store_, {"XY", "", true});
  auto asked = request();
  auto alignment = std::make_shared<AlignmentOutcome>(*asked.alignment);
  alignment->result.cautions = {"the skin at M1 is unsure by 0.9 mm"};
  asked.alignment = alignment;
  Treatment treatment(prepareTreatment(asked, devices()), fakes::targetAt(kMarker.reframe<Camera, Coil>()));
  waitFor([&] { return treatment.session().latest()->frame >= 2; });
  treatment.end("the window was closed");
  treatment.keepReport();
  const std::string report = readWholeFile(kept().folder / "report.html");
  EXPECT_THAT(report, HasSubstr("the skin at M1 is unsure by 0.9 mm"));
  EXPECT_THAT(report, HasSubstr("ended, but not by the operator: the window was closed"));
  EXPECT_THAT(report, ::testing::Not(HasSubstr("ended normally")));
}

}  // namespace
}  // namespace facenav::steps
