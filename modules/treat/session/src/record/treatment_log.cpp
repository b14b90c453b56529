#include "facenav/session/treatment_log.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "answer_keeper.h"
#include "facenav/casefile/session_log.h"
#include "facenav/casefile/session_pulses.h"
#include "facenav/casefile/session_so_far.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/core/without_folders.h"
#include "follow_on.h"
#include "second_coil_rows.h"
#include "state_changes.h"
#include "time_keeper.h"

namespace facenav::session {
namespace {

struct Event {
  std::string name, detail;
};

constexpr double kClockStep_s = 1.0;
constexpr double kLogRetry_s = 1.0;              // after a fault of the disk
constexpr std::size_t kMostUnwritten = 60 * 60;  // frames that wait for the disk: a minute's worth
constexpr double kLastPulses_s = 1.0;  // at the end: wait for a frame (kLongestWait_s), then for the disk

std::optional<casefile::SessionSoFar> soFar(const std::filesystem::path& folder) {
  return folder.empty() ? std::nullopt : std::optional(casefile::sessionSoFar(folder));
}

}  // namespace

struct TreatmentLog::Implementation {
  Implementation(std::shared_ptr<Session> session_, const std::filesystem::path& case_folder,
                 std::shared_ptr<const registration::ScalpField> scalp, const TreatmentLogOptions& options)
      : session(std::move(session_)),
        so_far(soFar(options.goes_on)),
        log(so_far ? casefile::SessionLog::goOn(options.goes_on) : casefile::SessionLog(case_folder)),
        folder(log.folder()),
        clock(options.clock),
        evidence(options.evidence_rig ? std::make_unique<EvidenceKeeper>(folder, *options.evidence_rig)
                                      : nullptr),
        pulses(folder, std::move(scalp), so_far.has_value(),
               [this, tell = options.placed](const casefile::Pulse& pulse) {
                 if (evidence) evidence->add(pulse);
                 if (tell) tell(pulse);
               }),
        pauses(so_far && so_far->is_paused),
        answers(so_far ? so_far->last_pulse : 0),
        times(folder, so_far ? std::optional(so_far->idle_s) : std::nullopt) {}

  const std::shared_ptr<Session> session;
  const std::optional<casefile::SessionSoFar> so_far;  // set for a continued session
  casefile::SessionLog log;                            // used only by the thread once it runs
  const std::filesystem::path folder;
  const std::function<std::chrono::system_clock::time_point()> clock;
  std::atomic<bool> is_stopping{false};
  const std::unique_ptr<EvidenceKeeper> evidence;  // null: none is kept
  PulseKeeper pulses;
  PauseTimes pauses;
  AnswerKeeper answers;
  const Timestamp begun = Timestamp::now();
  mutable std::mutex mutex;  // guards the members below, up to `failure`
  std::condition_variable followed;
  std::deque<std::shared_ptr<const NavigationState>> unwritten;  // the oldest first, without pictures
  std::deque<Event> events;
  std::string failure, end_words;
  std::atomic<bool> has_followed_all{false};  // true after the session's last frame was followed
  std::thread follower;               // gives pulses and pictures their frames; never waits for the disk
  std::optional<FollowOn> follow_on;  // used only by `follower`; set by the first frame
  std::thread thread;                 // writes
  // Members used only by the writing thread.
  StateChanges changes;
  TimeKeeper times;
  bool has_noted_end = false;
  std::string evidence_fault;
  std::optional<Timestamp> broken;  // time since which writing fails
  std::optional<double> ahead_s;    // time of day minus the steady clock
  Timestamp retry;

  void follow();
  void run();
  std::shared_ptr<const NavigationState> nextRow();
  void writeEvents();
  void writeAll(bool is_last);
  void noteEnd();
  std::string endWords() const;
  Timestamp until() const { return {begun.s + session->elapsed_s()}; }
  void noteEvidence();
  void noteClock();
  std::shared_ptr<const NavigationState> asLogged(std::shared_ptr<const NavigationState> state);
  void write(const NavigationState& state);
  template <class Work>
  void tried(Work work);
  void setFailure(const std::string& words);
  void awaitPulses() const;
  void end();
};

void TreatmentLog::Implementation::write(const NavigationState& state) {
  changes.note(state, log);  // before the rows, which belong to this coil
  if (state.frame >= 0) {
    const double t_s = state.captured.s;
    log.add(casefile::poseRow(state.frame, t_s, casefile::PoseObject::head, state.camera_T_mri));
    log.add(casefile::poseRow(state.frame, t_s, casefile::PoseObject::coil, state.camera_T_coil));
    const bool is_paused = pauses.holds(state.taken);
    times.follow(state, is_paused);
    if (!state.target.empty() && !is_paused)  // no guidance is given in a pause
      log.add(guidance::GuidanceRow{state.frame, t_s, state.target, state.guidance, state.gap});
    logSecondCoil(state, is_paused, log);
  }
}

std::shared_ptr<const NavigationState> TreatmentLog::Implementation::asLogged(
    std::shared_ptr<const NavigationState> state) {
  if (!so_far || !state || state->frame < 0) return state;
  if (!follow_on) follow_on = followOn(*so_far, *state);
  if (follow_on->frames == 0 && follow_on->seconds == 0) return state;
  auto shifted = std::make_shared<NavigationState>(*state);
  shifted->frame += follow_on->frames;
  shifted->captured.s += follow_on->seconds;
  return shifted;
}

/// Logs when pictures cannot be stored, and when they can again.
void TreatmentLog::Implementation::noteEvidence() {
  if (!evidence) return;
  const std::string fault = evidence->failure();
  if (fault == evidence_fault) return;
  log.addEvent("pulse pictures", fault.empty()
                                     ? formatted("kept again, %d frames are missing", evidence->leftOut())
                                     : "not kept: " + withoutFolders(fault));
  evidence_fault = fault;
}

/// Logs a change of the time of day. Frames and pulses use the steady clock, which nobody sets.
void TreatmentLog::Implementation::noteClock() {
  const double now_s = std::chrono::duration<double>(clock().time_since_epoch()).count() - Timestamp::now().s;
  if (ahead_s && std::abs(now_s - *ahead_s) > kClockStep_s)
    log.addEvent("clock set", formatted("the computer's clock was set %s by %.1f s; the order of pulses and "
                                        "the time between them are right",
                                        now_s < *ahead_s ? "back" : "forward", std::abs(now_s - *ahead_s)));
  ahead_s = now_s;
}

/// Writes the events; each leaves the list only after it is written.
void TreatmentLog::Implementation::writeEvents() {
  for (;;) {
    Event event;
    {
      std::lock_guard lock(mutex);
      if (events.empty()) return;
      event = events.front();
    }
    log.addEvent(event.name, event.detail);
    std::lock_guard lock(mutex);
    events.pop_front();
  }
}

/// Writes what waits besides the frames; answers wait until their pulse is in the file.
void TreatmentLog::Implementation::writeAll(bool is_last) {
  writeEvents();
  answers.write(folder, pulses.kept());
  times.keep(session->elapsed_s(), pauses.total_s(until()), is_last);
}

void TreatmentLog::Implementation::setFailure(const std::string& words) {
  std::lock_guard lock(mutex);
  failure = words;
}

/// Runs `work`. On a fault of the disk, reports it and tries again after a second.
template <class Work>
void TreatmentLog::Implementation::tried(Work work) {
  if (broken && !is_stopping && retry - Timestamp::now() > 0) return;
  try {
    if (broken) {
      const char* why = log.putBack() ? "; the session's folder had been removed and is made again" : "";
      log.addEvent("log resumed",
                   formatted("nothing was logged for %.1f s", Timestamp::now() - *broken) + why);
      broken.reset();
      setFailure("");
    }
    work();
  } catch (const std::exception& error) {
    if (!broken) {
      logWarning(std::string("the session's log is interrupted: ") + error.what());
      broken = Timestamp::now();
    }
    setFailure(error.what());
    retry = {Timestamp::now().s + kLogRetry_s};
  }
}

/// Notes the recording's end, once. A fault has its own event.
void TreatmentLog::Implementation::noteEnd() {
  if (has_noted_end || session->end() != SessionEnd::source) return;
  char detail[64];
  std::snprintf(detail, sizeof detail, "%.1f s after the start", session->elapsed_s());
  log.addEvent("recording ended", detail);
  has_noted_end = true;
}

/// Describes an end that nobody asked for; empty: a person ended the session.
std::string TreatmentLog::Implementation::endWords() const {
  if (session->end() == SessionEnd::fault) return "stopped by a fault";
  if (session->end() == SessionEnd::source) return "the recording had ended";
  std::lock_guard lock(mutex);
  return end_words;
}

/// Waits until the last pulses are in the file, because their answers need them there.
void TreatmentLog::Implementation::awaitPulses() const {
  const Timestamp begin = Timestamp::now();
  while (pulses.waiting() > 0 && pulses.failure().empty() && Timestamp::now() - begin < kLastPulses_s)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

void TreatmentLog::Implementation::end() {
  awaitPulses();
  while (const auto state = nextRow()) tried([&] { write(*state); });
  tried([this] {
    writeAll(true);
    noteEnd();
    log.addEvent("session ended", endWords());
    log.sync();
  });
}

void TreatmentLog::Implementation::follow() {
  while (!is_stopping) {
    const auto state = asLogged(session->take(std::chrono::milliseconds(50)));
    if (!state) {
      if (session->hasEnded()) {
        has_followed_all = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
      continue;
    }
    if (evidence) evidence->follow(*state);  // first, because the next line completes a pulse
    pulses.follow(*state);
    auto row = std::make_shared<NavigationState>(*state);
    row->images.reset();
    std::lock_guard lock(mutex);
    unwritten.push_back(std::move(row));
    if (unwritten.size() > kMostUnwritten) unwritten.pop_front();
    followed.notify_all();
  }
}

/// Returns the next state to write, waiting a moment for it; null: none.
std::shared_ptr<const NavigationState> TreatmentLog::Implementation::nextRow() {
  std::unique_lock lock(mutex);
  if (!is_stopping)
    followed.wait_for(lock, std::chrono::milliseconds(50), [this] { return !unwritten.empty(); });
  if (unwritten.empty()) return nullptr;
  const auto row = unwritten.front();
  unwritten.pop_front();
  return row;
}

void TreatmentLog::Implementation::run() {
  while (!is_stopping) {
    const bool was_all = has_followed_all;
    const auto state = nextRow();
    tried([&] {
      if (state) write(*state);
      writeAll(false);
      noteEvidence();
      noteClock();
      if (!state && was_all) noteEnd();
    });
  }
  end();
}

TreatmentLog::TreatmentLog(std::shared_ptr<Session> session, const std::filesystem::path& case_folder,
                           std::shared_ptr<const registration::ScalpField> scalp,
                           const TreatmentLogOptions& options)
    : implementation_(
          std::make_unique<Implementation>(std::move(session), case_folder, std::move(scalp), options)) {
  const auto& so_far = implementation_->so_far;
  if (so_far)
    implementation_->log.addEvent("session continued",
                                  formatted("after %d pulses and %.0f s", so_far->pulses(), so_far->idle_s));
  else
    implementation_->log.addEvent("session started");
  implementation_->follower = std::thread([i = implementation_.get()] { i->follow(); });
  implementation_->thread = std::thread([i = implementation_.get()] { i->run(); });
}

TreatmentLog::~TreatmentLog() {
  implementation_->is_stopping = true;
  implementation_->follower.join();
  implementation_->thread.join();
}

void TreatmentLog::addEvent(const std::string& event, const std::string& detail) {
  std::lock_guard lock(implementation_->mutex);
  implementation_->events.push_back({event, detail});
}

void TreatmentLog::addPulse(PulseTrigger trigger) {
  trigger.is_in_pause = implementation_->pauses.holds(trigger.at);
  if (!implementation_->pulses.add(trigger))
    addEvent("double trigger",
             trigger.source + formatted(", within %.2f s, not counted", trigger.dead_time_s));
}

void TreatmentLog::pause(const std::string& reason) {
  if (implementation_->pauses.begin(reason)) addEvent("pause", reason);
}

void TreatmentLog::resume() {
  const auto length_s = implementation_->pauses.end();
  if (!length_s) return;
  addEvent("resume");
  addEvent("pause length", formatted("%.0f s", *length_s));
}

const PauseTimes& TreatmentLog::pauses() const { return implementation_->pauses; }

double TreatmentLog::treated_s() const {
  const auto& i = *implementation_;
  return std::max(0.0, i.session->elapsed_s() - i.pauses.total_s(i.until()));
}

void TreatmentLog::endWith(const std::string& words) {
  std::lock_guard lock(implementation_->mutex);
  implementation_->end_words = words;
}

int TreatmentLog::newestPulse() const { return implementation_->pulses.added(); }

std::optional<AddedPulse> TreatmentLog::openPulse() const {
  const auto newest = implementation_->pulses.newest();
  return implementation_->answers.isOpen(newest.number) ? std::optional(newest) : std::nullopt;
}

bool TreatmentLog::answerPulse(double mep_uv) {
  return mep_uv >= 0 && mep_uv <= casefile::kLargestMep_uv &&
         implementation_->answers.add(implementation_->pulses.added(), mep_uv);
}

bool TreatmentLog::answerPulse(bool has_twitched) {
  return implementation_->answers.add(implementation_->pulses.added(), has_twitched);
}

bool TreatmentLog::takeBackAnswer() { return implementation_->answers.takeBack(); }

PulseCounts TreatmentLog::counts() const { return implementation_->pulses.counts(); }
std::optional<JudgedPulse> TreatmentLog::lastPulse() const { return implementation_->pulses.last(); }

std::vector<casefile::Pulse> TreatmentLog::takeKept() { return implementation_->pulses.takeKept(); }
int TreatmentLog::pulses() const { return implementation_->pulses.kept(); }
int TreatmentLog::pulsesWaiting() const { return implementation_->pulses.waiting(); }

const std::filesystem::path& TreatmentLog::folder() const { return implementation_->folder; }

std::string TreatmentLog::failure() const {
  {
    std::lock_guard lock(implementation_->mutex);
    if (!implementation_->failure.empty()) return implementation_->failure;
  }
  return implementation_->pulses.failure();
}

}  // namespace facenav::session
