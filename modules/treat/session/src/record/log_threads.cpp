#include "log_threads.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "facenav/casefile/session_pulses.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/core/number_text.h"
#include "facenav/core/without_folders.h"
#include "second_coil_rows.h"

namespace facenav::session {
namespace {

constexpr double kClockStep_s = 1.0;
constexpr double kLogRetry_s = 1.0;              // after a fault of the disk
constexpr std::size_t kMostUnwritten = 60 * 60;  // frames that wait for the disk: a minute's worth
constexpr double kLastPulses_s = 1.0;  // at the end: wait for a frame (kLongestWait_s), then for the disk

std::optional<casefile::SessionSoFar> soFar(const std::filesystem::path& folder) {
  return folder.empty() ? std::nullopt : std::optional(casefile::sessionSoFar(folder));
}

}  // namespace

TreatmentLog::Implementation::Implementation(std::shared_ptr<Session> session_,
                                             const std::filesystem::path& case_folder,
                                             std::shared_ptr<const registration::ScalpField> scalp,
                                             const TreatmentLogOptions& options)
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

/// Says what failed. A folder that was removed is named as such, whichever of its files was to be written.
std::string TreatmentLog::Implementation::faultWords(const std::exception& error) const {
  if (std::filesystem::exists(folder / "events.jsonl")) return error.what();
  return Error("cannot be written (it was removed)", folder.string(), "leave the case's folder in its place")
      .what();
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
    const std::string words = faultWords(error);
    if (!broken) {
      logWarning("the session's log is interrupted: " + words);
      broken = Timestamp::now();
    }
    setFailure(words);
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

}  // namespace facenav::session
