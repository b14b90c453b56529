// Live cameras from the command line: two network cameras of the test show a patient of the virtual room.
// `align --live`, then `track --live` with pulses over UDP while one camera fails and returns, then `guide
// --live` with pulses by the keyboard, ended by Ctrl-C.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <mutex>
#include <set>

#include "facenav/capture/recording.h"
#include "facenav/capture/rig_store.h"
#include "facenav/capture/swinging_source.h"
#include "facenav/casefile/case_store.h"
#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/poses_csv.h"
#include "support/command_line.h"
#include "support/conversation.h"
#include "support/jpeg_server.h"
#include "support/pulse_sender.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

constexpr int kPeriod_ms = 66;

/// Number of the exposure of both cameras, which expose at whole multiples of the period.
std::int64_t shutterNumber() { return std::llround(1000 * Timestamp::now().s / kPeriod_ms); }

/// Pictures that both cameras show now, as JPEG.
struct Scene {
  std::mutex mutex;
  std::vector<std::string> left, right;  // the film, forwards and backwards, repeated
  std::int64_t begun = 0;

  std::string now(bool is_left) {
    const std::lock_guard lock(mutex);
    const auto& film = is_left ? left : right;
    return film[std::size_t(capture::swungFrame(shutterNumber() - begun, std::int64_t(film.size())))];
  }
  /// Shows the frames with a counter in a corner, so that pictures differ as by a sensor's noise; a repeated
  /// picture is ignored.
  void show(const std::vector<cameras::StereoFrame>& frames) {
    std::vector<std::string> lefts, rights;
    for (std::size_t i = 0; i < std::max<std::size_t>(frames.size(), 3); ++i)
      for (const bool is_left : {true, false}) {
        const auto& frame = frames[i % frames.size()];
        cv::Mat image = (is_left ? frame.left : frame.right).clone();
        image(cv::Rect(0, 0, 8, 8)).setTo(20 * (i % 10));
        (is_left ? lefts : rights).push_back(JpegServer::largeJpeg(image, 97));
      }
    const std::lock_guard lock(mutex);
    left = lefts;
    right = rights;
    begun = shutterNumber();
  }
};

class LiveSession : public ::testing::Test {
 protected:
  void SetUp() override {
    FACENAV_NEEDS(virtualPatientMri());
    ::signal(SIGPIPE, SIG_IGN);
    run("prepare '" + virtualPatientMri().string() + "' -o " + in(case_) + " -q");
    run("check " + in(case_) + " --by AB --acknowledge-findings");
    run("target " + in(case_) + " --name 'M1 hand L' --mni -37 -21 58");
    run("simulate treatment --case " + in(case_) + " --frames 24 --frames-per-s 12 --seed 1 -o " +
        in(recording_) + " -q");
    const auto recording = capture::openRecording(recording_);
    pair_ = recording.capture.value();
    const auto source = capture::makeSource(recording);
    while (const auto frame = source->next()) film_.push_back(*frame);
    scene_.show({pair_.pattern});
    keepRig(recording.rig);
  }
  static std::string in(const fs::path& path) { return "'" + path.string() + "'"; }
  CommandResult run(const std::string& words, int status = 0) const {
    const auto result = runFacenav(words, 200);
    EXPECT_EQ(result.status, status) << words << "\n" << result.errors;
    return result;
  }
  void keepRig(const cameras::StereoRig& rig) const {
    capture::NamedRig named;
    named.name = "room";
    named.rig = rig;
    named.left.emplace();
    named.left->identity = {"stream", left_.url(), "", "", ""};
    named.left->settings.frames_per_s = 15;
    named.right = named.left;
    named.right->identity.address = right_.url();
    capture::RigStore(rigs_).write(named, Existing::refuse);
  }
  std::vector<std::string> live(std::vector<std::string> verb, const std::vector<std::string>& more) const {
    for (const auto& word :
         {std::string("--live"), std::string("room"), std::string("--rigs"), rigs_.string()})
      verb.push_back(word);
    verb.insert(verb.end(), more.begin(), more.end());
    return verb;
  }
  void refuseAHeadThatMoved();
  void align();
  std::string track();
  void guide();
  void trackMoved();
  void requirePoses(const fs::path& session);

  TemporaryFolder folder_;
  fs::path case_ = folder_.path() / "case", recording_ = folder_.path() / "recording",
           rigs_ = folder_.path() / "rigs";
  capture::CapturePair pair_;
  std::vector<cameras::StereoFrame> film_;
  Scene scene_;
  JpegServer left_{[this](int) { return scene_.now(true); }, kPeriod_ms},
      right_{[this](int) { return scene_.now(false); }, kPeriod_ms};
  PulseSender sender_;
};

/// Refuses a head that moved: the dots show it where it was before the picture without dots. The picture
/// without dots alone is of one moment.
void LiveSession::refuseAHeadThatMoved() {
  const fs::path moved = folder_.path() / "moved";
  fs::copy(recording_, moved, fs::copy_options::recursive);
  for (const std::string side : {"left", "right"}) {
    std::set<fs::path> frames;
    for (const auto& file : fs::directory_iterator(recording_ / side)) frames.insert(file.path());
    ASSERT_EQ(frames.size(), film_.size());
    fs::copy_file(*std::next(frames.begin(), 12), moved / "capture" / ("plain_" + side + ".png"),
                  fs::copy_options::overwrite_existing);
  }
  EXPECT_THAT(run("align " + in(case_) + " " + in(moved) + " --using dots -q", 1).errors,
              HasSubstr("between the picture with dots and the one without; hold the head still"));
  EXPECT_FALSE(casefile::CaseStore::open(case_).alignment());
  const fs::path again = folder_.path() / "again";
  fs::copy(case_, again, fs::copy_options::recursive);
  EXPECT_THAT(run("align " + in(again) + " " + in(moved), 0).output,
              HasSubstr("the pair with dots was refused (not aligned: the head moved by"));
  EXPECT_TRUE(casefile::CaseStore::open(again).alignment());
}

/// Aligns; the projector is switched off between the two answers.
void LiveSession::align() {
  Conversation facenav(live({"align", case_.string()}, {"--picture", (folder_.path() / "skin.png").string()}),
                       Conversation::Hears::output_and_errors);
  ASSERT_TRUE(facenav.hearWords("projector on", 60));
  facenav.say("");
  ASSERT_TRUE(facenav.hearWords("projector off", 60));
  scene_.show({pair_.plain});
  std::this_thread::sleep_for(1500ms);
  facenav.say("");
  EXPECT_EQ(facenav.end(), 0);
  const auto alignment = casefile::CaseStore::open(case_).alignment();
  ASSERT_TRUE(alignment);
  EXPECT_LT(alignment->predicted_tre_mm.at("M1 hand L"), 1.5);
  EXPECT_TRUE(fs::exists(folder_.path() / "skin.png"));
  const auto truth = capture::readTruth(recording_ / "truth" / "head.csv");
  EXPECT_FALSE(truth.empty());
}

/// Reads until a line has `key`; null after the limit.
nlohmann::json hearKey(Conversation& facenav, const char* key, double limit_s = 60) {
  for (const double until_s = Timestamp::now().s + limit_s; Timestamp::now().s < until_s;) {
    const auto line = facenav.hearWithin(until_s - Timestamp::now().s);
    if (!line || line->is_discarded()) break;
    if (line->contains(key)) return *line;
  }
  return nlohmann::json::object();
}

/// Sends a pulse and returns its verdict.
std::string pulseStatus(const PulseSender& sender, Conversation& facenav) {
  sender.send(50);
  const auto told = hearKey(facenav, "pulse", 10);
  return told.is_object() ? told.value("status", "") : "none";
}

std::string LiveSession::track() {
  scene_.show(film_);
  Conversation facenav(
      live({"track"}, {"--case", case_.string(), "--coil", (recording_ / "coil.json").string(), "--pulses",
                       sender_.source(), "--commands", "-o", (folder_.path() / "poses.csv").string()}));
  const std::string name = hearKey(facenav, "session").value("session", "");
  EXPECT_FALSE(name.empty());
  EXPECT_EQ(hearKey(facenav, "check").value("check", false), true) << "the alignment is checked first";
  EXPECT_NE(pulseStatus(sender_, facenav), "none");
  std::this_thread::sleep_for(1s);
  right_.switchOff(true);
  const auto away = hearKey(facenav, "cameras", 20);
  EXPECT_EQ(away.value("cameras", ""), "away");
  EXPECT_THAT(away.value("words", ""), HasSubstr(right_.url()));
  EXPECT_EQ(pulseStatus(sender_, facenav), "lost");
  right_.switchOff(false);
  EXPECT_EQ(hearKey(facenav, "cameras", 30).value("cameras", ""), "back");
  EXPECT_EQ(hearKey(facenav, "check").value("check", false), true) << "and again when it is back";
  std::this_thread::sleep_for(2500ms);
  facenav.say("end");
  EXPECT_EQ(facenav.end(), 0);
  return name;
}

/// Requires poses that are tracked, lost while the camera was away, and tracked again.
void LiveSession::requirePoses(const fs::path& session) {
  // On a busy machine the two streams may be out of step for a moment at other times, too.
  struct Away {
    int before, frames;
  };
  std::vector<Away> runs;
  int tracked = 0;
  bool was_away = false;
  for (const auto& row : casefile::readPoses(session / "poses.csv")) {
    if (row.object != casefile::PoseObject::head) continue;
    tracked += row.pose.has_value();
    const bool is_away = !row.pose && row.reason == LostReason::camera;
    if (is_away && !was_away) runs.push_back({tracked, 0});
    if (is_away) ++runs.back().frames;
    was_away = is_away;
  }
  const bool was_away_between = std::any_of(runs.begin(), runs.end(), [&](const Away& run) {
    return run.before > 5 && run.frames > 3 && tracked - run.before > 10;
  });
  EXPECT_TRUE(was_away_between) << runs.size() << " times lost for a camera, " << tracked
                                << " frames tracked";
  std::string events;
  const auto kept = casefile::readSession(session);
  for (const auto& event : kept.events) events += event.event + ": " + event.detail + "\n";
  EXPECT_THAT(events, HasSubstr("cameras back: after"));
  EXPECT_EQ(kept.pulses.pulses.size(), 2u);
  for (const char* file : {"guidance.csv", "report.html", "evidence"})
    EXPECT_TRUE(fs::exists(session / file)) << file;
}

void LiveSession::guide() {
  const fs::path table = folder_.path() / "guidance.csv";
  Conversation facenav(
      live({"guide", case_.string()}, {"--coil", (recording_ / "coil.json").string(), "--target", "M1 hand L",
                                       "--pulses", "keyboard", "-o", table.string()}));
  const auto session = [&] { return casefile::readSession(casefile::findSession(case_, "")); };
  const auto before = session().folder;
  for (int i = 0; i < 600 && session().folder == before; ++i) std::this_thread::sleep_for(100ms);
  ASSERT_NE(session().folder, before);
  std::this_thread::sleep_for(3s);
  facenav.say("");
  std::this_thread::sleep_for(300ms);
  facenav.interrupt();
  EXPECT_EQ(facenav.end(), 0);
  const auto kept = session();
  ASSERT_EQ(kept.pulses.pulses.size(), 1u);
  EXPECT_EQ(kept.pulses.pulses.front().pulse.source, "keyboard");
  const std::string text = readText(table);
  EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 20);
  EXPECT_EQ(text, readText(kept.folder / "guidance.csv"));
}

/// Tracks with a rig whose last check found it bumped: no pose is shown, and the repair is named.
void LiveSession::trackMoved() {
  const capture::RigStore store(rigs_);
  EXPECT_NE(store.read("room").last_check->state, "moved") << store.read("room").last_check->words;
  store.note("room", {"2020-01-02T08:00:00Z", "moved", "it was bumped"});
  const fs::path table = folder_.path() / "moved.csv";
  const auto moved =
      run("track --live room --rigs " + in(rigs_) + " --case " + in(case_) + " --seconds 6 -o " + in(table));
  EXPECT_THAT(moved.errors, HasSubstr("a fault that is not repaired: it was bumped"));
  EXPECT_THAT(moved.errors, HasSubstr("facenav-gui --set-up --rig room"));
  int rows = 0;
  for (const auto& row : casefile::readPoses(table)) {
    ++rows;
    EXPECT_FALSE(row.pose);
  }
  EXPECT_GT(rows, 10);
}

TEST_F(LiveSession, AlignsTracksOverAnUnpluggedCameraAndGuides) {
  if (IsSkipped() || HasFailure()) return;
  const auto early = live({"track"}, {"--case", case_.string(), "-o", (folder_.path() / "p.csv").string()});
  std::string words;
  for (const auto& word : early) words += " " + in(word);
  EXPECT_THAT(run(words, 1).errors, HasSubstr("the case is not aligned"));
  refuseAHeadThatMoved();
  align();
  if (HasFatalFailure() || HasFailure()) return;
  const auto name = track();
  requirePoses(case_ / "sessions" / name);
  guide();
  const auto timed = run("track --live room --rigs " + in(rigs_) + " --case " + in(case_) +
                         " --seconds 2 -o " + in(folder_.path() / "timed.csv"));
  EXPECT_THAT(timed.output, HasSubstr("0 pulses on target"));
  trackMoved();
  EXPECT_THAT(run("track --live room --rigs " + in(rigs_) + " -o " + in(folder_.path() / "x.csv"), 2).errors,
              HasSubstr("a session belongs to a case"));
}

}  // namespace
}  // namespace facenav::testing
