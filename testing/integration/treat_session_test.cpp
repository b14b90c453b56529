// One session from beginning to end by the command line tool, on a recording of the virtual room: hotspot,
// threshold, 200 pulses at 10 Hz in trains over UDP, a pause, kill -9 in the middle, the return, the report.
// The room's truth gives the coil's pose at each pulse.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <future>
#include <map>
#include <random>
#include <thread>

#include "facenav/capture/recording.h"
#include "facenav/capture/swinging_source.h"
#include "facenav/casefile/case_store.h"
#include "facenav/casefile/evidence.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/casefile/session_so_far.h"
#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/interpolate.h"
#include "facenav/geometry/pose_error.h"
#include "facenav/geometry/rotation.h"
#include "support/command_line.h"
#include "support/conversation.h"
#include "support/pulse_sender.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kFrames = 30, kPlanned = 200, kInTrain = 20;
constexpr double kStep_s = 0.1, kPause_s = 0.5;
constexpr double kFirst_pct = 55, kTag_pct = 0.001;  // the intensity identifies the pulse
const char* const kName = "Jane Doe";

int tagOf(const casefile::Pulse& pulse) {
  return int(std::lround((pulse.intensity_pct.value_or(0) - kFirst_pct) / kTag_pct));
}

/// A prepared, signed-off and planned case, and a recording of its patient.
class TreatSession : public ::testing::Test {
 protected:
  void SetUp() override {
    FACENAV_NEEDS(virtualPatientMri());
    ::signal(SIGPIPE, SIG_IGN);
    run("prepare '" + virtualPatientMri().string() + "' -o " + at_case_ + " --label '" + kName + "' -q");
    run("check " + at_case_ + " --by AB --acknowledge-findings");
    run("target " + at_case_ + " --name 'M1 hand L' --mni -37 -21 58");
    run("plan " + at_case_ + " --target 'M1 hand L' --grid 3 3 --spacing-mm 10");
    std::ofstream(folder_.path() / "protocol.json")
        << R"({"name": "M1 10 Hz", "version": 1, "pulses": 200, "trains": 10, "frequency_hz": 10,
              "pause_s": 0.5, "output_pct": 55})";
    run("plan " + at_case_ + " --protocol '" + (folder_.path() / "protocol.json").string() + "'");
    run("simulate treatment --case " + at_case_ + " --frames " + std::to_string(kFrames) +
        " --frames-per-s 15 --seed 1 -o '" + recording_.string() + "' -q");
  }
  CommandResult run(const std::string& words) const {
    const auto result = runFacenav(words, 200);
    EXPECT_EQ(result.status, 0) << words << "\n" << result.errors;
    return result;
  }
  std::vector<std::string> tracking(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"track",      recording_.string(),
                                   "--case",     case_.string(),
                                   "--pulses",   sender_.source(),
                                   "--commands", "--passes",
                                   "0",          "-q",
                                   "-o",         (folder_.path() / "poses.csv").string()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  void hunt();
  void findThreshold();
  void requireKept(const fs::path& session, const std::vector<int>& told, int sent);
  void requireTruePoses(const fs::path& session, const std::map<int, Timestamp>& sent,
                        std::int64_t killed_at);
  void requireEvidence(const fs::path& session, std::int64_t killed_at);
  void requireReport(const fs::path& session);

  TemporaryFolder folder_;
  fs::path case_ = folder_.path() / "case", recording_ = folder_.path() / "recording";
  std::string at_case_ = "'" + case_.string() + "'";
  PulseSender sender_;
};

int tagOf(const nlohmann::json& told) {
  return int(std::lround((told.value("intensity_pct", 0.0) - kFirst_pct) / kTag_pct));
}

/// Reads until a line has `key`; pulses reported before it are added to `told`.
nlohmann::json hearUntil(Conversation& facenav, const char* key, std::vector<int>* told = nullptr) {
  for (;;) {
    const auto line = facenav.hearWithin(60);
    if (!line || line->is_discarded()) return nlohmann::json::object();
    if (told && line->contains("pulse")) told->push_back(tagOf(*line));
    if (line->contains(key)) return *line;
  }
}

void TreatSession::hunt() {
  Conversation facenav(tracking({}));
  const std::string name = hearUntil(facenav, "session").value("session", "");
  ASSERT_FALSE(name.empty());
  const auto targets = casefile::CaseStore::open(case_).targets().targets;
  ASSERT_EQ(targets.size(), 9u);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  for (int i = 0; i < 18; ++i) {
    facenav.say("target " + targets[std::size_t(i / 2)].name);
    hearUntil(facenav, "done");
    sender_.send(50);
    ASSERT_TRUE(hearUntil(facenav, "pulse").contains("pulse"));
    const auto kept = casefile::readSessionPulses(case_ / "sessions" / name);
    ASSERT_EQ(int(kept.pulses.size()), i + 1) << "what is told is on the disk";
    if (const auto pose = kept.pulses.back().pulse.mri_T_coil()) {  // the muscle responds over the hand area
      const double off_mm = (pose->translation_mm() - targets[0].mri_T_target.translation_mm()).norm();
      facenav.say("mep " + std::to_string(10 + 1500 * std::exp(-0.5 * off_mm * off_mm / 36)));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(70));
  }
  facenav.say("end");
  EXPECT_EQ(facenav.end(), 0);
  const auto found = run("hotspot " + at_case_ + " --json");
  ASSERT_EQ(found.status, 0);
  const auto spot = nlohmann::json::parse(found.output);
  const Point<Mri> peak(spot["peak_mm"][0], spot["peak_mm"][1], spot["peak_mm"][2]);
  const auto in_target = (targets.front().mri_T_target.inverse() * peak).mm;  // on the cortex's outside
  EXPECT_LT(in_target.head<2>().norm(), 10) << "beside the hand area's axis: " << in_target.transpose();
  EXPECT_GE(spot["responses"].get<int>(), 3);
}

void TreatSession::findThreshold() {
  Conversation facenav({"threshold", case_.string(), "--json", "--muscle", "FDI right"});
  auto state = facenav.hear();
  for (int pulse = 0; pulse < 40 && state.is_object() && !state["done"].get<bool>(); ++pulse) {
    facenav.say(nlohmann::json{{"response", state["next_pct"].get<double>() >= 50}}.dump());
    state = facenav.hear();
  }
  ASSERT_TRUE(state.is_object());
  EXPECT_NEAR(state["estimate_pct"], 49.5, 2);
  EXPECT_EQ(facenav.end(), 0);
}

/// Requires each reported pulse once, and none that was not sent.
void TreatSession::requireKept(const fs::path& session, const std::vector<int>& told, int sent) {
  std::map<int, int> kept;
  int number = 0;
  for (const auto& reviewed : casefile::readSessionPulses(session).pulses) {
    EXPECT_EQ(reviewed.pulse.number, ++number);
    ++kept[tagOf(reviewed.pulse)];
  }
  for (const auto& [tag, times] : kept) {
    EXPECT_EQ(times, 1) << "pulse " << tag;
    EXPECT_TRUE(tag >= 1 && tag <= sent) << tag;
  }
  for (const int tag : told) EXPECT_TRUE(kept.count(tag)) << "pulse " << tag << " was told, and is lost";
}

/// Logged frames of the second run follow the first one's; both began with the recording's first frame.
std::size_t shownFrame(std::int64_t logged, std::int64_t killed_at) {
  return std::size_t(capture::swungFrame(logged > killed_at ? logged - killed_at - 1 : logged, kFrames));
}

template <class Pose>
Pose truthAt(const std::map<std::int64_t, Eigen::Isometry3d>& truth, const casefile::Pulse& pulse,
             std::int64_t killed_at) {
  const auto at = [&](int which) {
    return Pose::fromIsometry(
        truth.at(std::int64_t(shownFrame((*pulse.frames)[std::size_t(which)], killed_at))));
  };
  return interpolated(at(0), at(1), pulse.fraction);
}

void TreatSession::requireTruePoses(const fs::path& session, const std::map<int, Timestamp>& sent,
                                    std::int64_t killed_at) {
  const auto head = capture::readTruth(recording_ / "truth" / "head.csv");
  const auto marker = capture::readTruth(recording_ / "truth" / "coil.csv");
  const auto marker_T_coil = coil_tracking::readCoil(recording_ / "coil.json").marker_T_coil();
  std::vector<double> off_mm, late_s;
  std::map<bool, std::vector<double>> clock_s;  // of each run: the film's clock against the machine's
  for (const auto& reviewed : casefile::readSessionPulses(session).pulses) {
    const auto& pulse = reviewed.pulse;
    late_s.push_back(std::abs(pulse.steady_s - sent.at(tagOf(pulse)).s));
    const auto pose = pulse.mri_T_coil();
    if (!pose) continue;
    ASSERT_TRUE(pulse.frames);
    clock_s[(*pulse.frames)[0] > killed_at].push_back(*pulse.t_s - pulse.steady_s);
    const auto camera_T_mri = truthAt<RigidTransform<Camera, Mri>>(head, pulse, killed_at);
    const auto camera_T_marker = truthAt<RigidTransform<Camera, Marker>>(marker, pulse, killed_at);
    const auto error = poseError(camera_T_mri.inverse() * camera_T_marker * marker_T_coil, *pose);
    EXPECT_LT(error.translation_mm, 3.0) << "pulse " << pulse.number;
    EXPECT_LT(error.rotation_rad * kDegPerRad, 2.0) << "pulse " << pulse.number;
    off_mm.push_back(error.translation_mm);
  }
  ASSERT_GE(off_mm.size(), 50u) << "of 200; the coil is seen in two thirds of the film";
  std::printf("%zu pulses with a pose: off by %.2f mm (median), %.2f mm (worst)\n", off_mm.size(),
              median(off_mm), *std::max_element(off_mm.begin(), off_mm.end()));
  EXPECT_LT(median(off_mm), 1.0);
  EXPECT_LT(median(late_s), 0.005) << "the time of a pulse is when it was sent";
  for (auto& [is_second, offsets_s] : clock_s) {
    const double middle_s = median(offsets_s);
    for (double& offset_s : offsets_s) offset_s = std::abs(offset_s - middle_s);
    EXPECT_LT(median(offsets_s), 0.02) << "a third of a frame: each pulse has the frames of its own time";
  }
}

/// Requires private pictures from which the poses can be computed again.
void TreatSession::requireEvidence(const fs::path& session, std::int64_t killed_at) {
  const fs::path evidence = casefile::evidenceFolder(session), again = folder_.path() / "again.csv";
  int wanted = 0, there = 0;
  for (const auto& reviewed : casefile::readSessionPulses(session).pulses) {
    wanted += reviewed.pulse.frames.has_value();
    there += casefile::evidenceFrame(session, reviewed.pulse).has_value();
  }
  EXPECT_GE(there, wanted - 4) << "a kill may take those that were on their way";
  for (const auto& entry : fs::recursive_directory_iterator(session))
    EXPECT_EQ(entry.status().permissions() & (fs::perms::group_all | fs::perms::others_all), fs::perms::none)
        << entry.path();
  run("track '" + evidence.string() + "' --case " + at_case_ + " --coil '" +
      (recording_ / "coil.json").string() + "' -q -o '" + again.string() + "'");
  const auto truth = capture::readTruth(recording_ / "truth" / "head.csv");
  const auto target = casefile::CaseStore::open(case_).targets().targets.front().cortex_point;
  int solved = 0;
  for (const auto& row : casefile::readPoses(again)) {
    if (row.object != casefile::PoseObject::head || !row.pose) continue;
    ++solved;
    const auto& true_pose = truth.at(std::int64_t(shownFrame(row.frame, killed_at)));
    EXPECT_LT((*row.pose * target.mm - true_pose * target.mm).norm(), 3.0) << "frame " << row.frame;
  }
  EXPECT_GE(solved, 20) << "of " << there << " pulses with pictures";
}

/// Number of trains in the log; a kill cuts a train in two. A pulse alone is no train.
int trainsGiven(const fs::path& session) {
  int trains = 0, in_train = 0;
  double last_s = -1e9;
  for (const auto& reviewed : casefile::readSessionPulses(session).pulses) {
    in_train = reviewed.pulse.steady_s - last_s > 0.5 * (kStep_s + kPause_s) ? 1 : in_train + 1;
    trains += in_train == 2;
    last_s = reviewed.pulse.steady_s;
  }
  return trains;
}

void TreatSession::requireReport(const fs::path& session) {
  const bool has_window = fs::exists(fs::path(FACENAV_CLI).parent_path() / "facenav-gui");
  const fs::path page = folder_.path() / "page.html", csv = folder_.path() / "pulses.csv";
  run("report " + at_case_ + " " + session.filename().string() + " --no-pictures" +
      (has_window ? " --pdf" : "") + " -o '" + page.string() + "'");
  run("pulses " + at_case_ + " " + session.filename().string() + " -o '" + csv.string() + "'");
  const std::string html = readText(page);
  EXPECT_THAT(html, HasSubstr("200 of 200"));
  EXPECT_THAT(html, HasSubstr(std::to_string(trainsGiven(session)) + " of 10")) << "trains";
  EXPECT_THAT(html, HasSubstr("10.0 Hz (median)"));
  for (const char* words : {"coil too warm", "passed: face", "Gone on with"})
    EXPECT_THAT(html, HasSubstr(words));
  const std::string table = readText(csv);
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), kPlanned + 1);
  if (has_window) {
    EXPECT_EQ(readText(folder_.path() / "page.pdf").substr(0, 5), "%PDF-");
  }
  for (const auto& file : {page, csv, folder_.path() / "page.pdf", session / "report.html",
                           session / "events.jsonl", session / "pulses.jsonl", session / "poses.csv"})
    EXPECT_THAT(readText(file), Not(HasSubstr("Jane"))) << file;
}

/// Sends trains of 10 Hz from pulse `first` on, and reads the reports meanwhile. Ends after `last`, or when
/// `enough` were reported.
int sendTrains(const PulseSender& sender, Conversation& facenav, int first, int last, std::size_t enough,
               std::map<int, Timestamp>& sent, std::vector<int>& told) {
  for (int tag = first; tag <= last; ++tag) {
    const bool begins = (tag - 1) % kInTrain == 0;
    const double end_s = Timestamp::now().s + (begins ? kPause_s : kStep_s);
    while (Timestamp::now().s < end_s) {
      const auto line = facenav.hearWithin(std::max(0.0, end_s - Timestamp::now().s));
      if (line && line->contains("pulse")) told.push_back(tagOf(*line));
    }
    sent[tag] = sender.send(kFirst_pct + kTag_pct * tag);
    if (told.size() >= enough) return tag;
  }
  return last;
}

TEST_F(TreatSession, HotspotThresholdPulsesKillReturnAndReport) {
  if (IsSkipped() || HasFailure()) return;
  {  // two programs, as two people would use them
    auto threshold = std::async(std::launch::async, [this] { findThreshold(); });
    hunt();
    threshold.get();
  }
  if (HasFailure()) return;
  std::map<int, Timestamp> sent;
  std::vector<int> told;
  std::string name;
  int last_sent = 0;
  {
    Conversation facenav(tracking({"--target", "M1 hand L"}));
    const auto begin = hearUntil(facenav, "session");
    name = begin.value("session", "");
    EXPECT_EQ(begin.value("planned", 0), kPlanned);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    last_sent = sendTrains(sender_, facenav, 1, 60, kPlanned, sent, told);
    facenav.say("pause coil too warm");
    hearUntil(facenav, "done", &told);
    facenav.say("resume");
    hearUntil(facenav, "done", &told);
    std::mt19937 random(5);
    last_sent = sendTrains(sender_, facenav, last_sent + 1, kPlanned, 80 + random() % 30, sent, told);
    facenav.kill();
    hearUntil(facenav, "nothing", &told);  // reports before the kill
    EXPECT_EQ(facenav.end(), 128 + SIGKILL);
  }
  ASSERT_LT(last_sent, kPlanned) << "it was killed in the middle";
  const fs::path session = case_ / "sessions" / name;
  requireKept(session, told, last_sent);
  const auto so_far = casefile::sessionSoFar(session);
  EXPECT_FALSE(so_far.has_ended || so_far.is_running || so_far.is_paused);
  ASSERT_TRUE(so_far.last_frame);
  EXPECT_GE(so_far.pulses(), int(told.size()));
  const int missing = kPlanned - so_far.pulses();
  {
    const Timestamp begin = Timestamp::now();
    Conversation facenav(tracking({"--continue"}));
    const auto back = hearUntil(facenav, "session");
    EXPECT_EQ(back.value("session", ""), name) << "the same session";
    EXPECT_EQ(back.value("pulses", 0), so_far.pulses()) << "counts go on";
    EXPECT_EQ(runFacenav("track '" + recording_.string() + "' --case " + at_case_ +
                         " --pulses udp:0 --continue -o '" + (folder_.path() / "x.csv").string() + "'")
                  .status,
              1)
        << "one program at a time writes a session";
    EXPECT_TRUE(hearUntil(facenav, "check")["check"].get<bool>()) << "nothing moved";
    std::printf("back and checked %.1f s after the start of the program\n", Timestamp::now() - begin);
    sendTrains(sender_, facenav, last_sent + 1, last_sent + missing, kPlanned, sent, told);
    while (casefile::sessionSoFar(session).pulses() < kPlanned && Timestamp::now() - begin < 120)
      if (const auto line = facenav.hearWithin(0.2); !line) continue;
    facenav.say("end");
    EXPECT_EQ(facenav.end(), 0);
  }
  requireKept(session, told, last_sent + missing);
  ASSERT_EQ(casefile::sessionSoFar(session).pulses(), kPlanned);
  auto evidence = std::async(std::launch::async, [&] { requireEvidence(session, *so_far.last_frame); });
  requireTruePoses(session, sent, *so_far.last_frame);
  requireReport(session);
  evidence.get();
}

}  // namespace
}  // namespace facenav::testing
