#include "facenav/session/treatment_log.h"

#include <atomic>
#include <cmath>
#include <cstdio>
#include <deque>
#include <mutex>
#include <thread>

#include "facenav/casefile/session_log.h"
#include "facenav/core/log.h"

namespace facenav::session {
namespace {

struct Event {
  std::string name, detail;
};

std::string placeOf(const guidance::GuidanceState& guidance) {
  std::string words = guidance::toString(guidance.state);
  if (!guidance.values) return words;
  char figures[64];
  std::snprintf(figures, sizeof figures, ", %.1f mm, %.0f deg", guidance.values->distance_mm,
                guidance.values->tilt_rad * 180.0 / M_PI);
  return words + figures;
}

}  // namespace

struct TreatmentLog::Implementation {
  Implementation(std::shared_ptr<Session> session_, const std::filesystem::path& case_folder)
      : session(std::move(session_)), log(case_folder), folder(log.folder()) {}

  const std::shared_ptr<Session> session;
  casefile::SessionLog log;  // used only by the thread once it runs
  const std::filesystem::path folder;
  std::atomic<bool> is_stopping{false};
  mutable std::mutex mutex;  // guards events, failure, pulses
  std::deque<Event> events;
  std::string failure;
  int pulses = 0;
  std::thread thread;
  // Used only by the thread: what held at the previous frame.
  bool has_head = false, has_coil = false, has_faulted = false, has_noted_end = false;

  void run();
  void writeEvents();
  void noteEnd();
  void write(const NavigationState& state);
  void noteChange(bool& has, bool has_now, const char* what, const std::string& why);
};

void TreatmentLog::Implementation::noteChange(bool& has, bool has_now, const char* what,
                                              const std::string& why) {
  if (has_now != has) log.addEvent(std::string(what) + (has_now ? " found" : " lost"), has_now ? "" : why);
  has = has_now;
}

void TreatmentLog::Implementation::write(const NavigationState& state) {
  if (state.frame >= 0) {
    const double t_s = state.captured.s;
    log.add(casefile::poseRow(state.frame, t_s, casefile::PoseObject::head, state.camera_T_mri));
    log.add(casefile::poseRow(state.frame, t_s, casefile::PoseObject::coil, state.camera_T_coil));
    if (!state.target.empty()) log.add(guidance::GuidanceRow{state.frame, t_s, state.target, state.guidance});
  }
  noteChange(has_head, bool(state.camera_T_mri), "face",
             state.camera_T_mri ? "" : toString(state.camera_T_mri.reason()));
  noteChange(has_coil, bool(state.camera_T_coil), "coil",
             state.camera_T_coil ? "" : toString(state.camera_T_coil.reason()));
  const std::string& fault = state.failure.empty() ? state.rig_fault : state.failure;
  if (!fault.empty() && !has_faulted) log.addEvent("fault", fault);
  has_faulted = !fault.empty();
}

void TreatmentLog::Implementation::writeEvents() {
  std::deque<Event> waiting;
  {
    std::lock_guard lock(mutex);
    waiting.swap(events);
  }
  for (const auto& event : waiting) log.addEvent(event.name, event.detail);
}

/// Notes the recording's end, once. A fault has its own event.
void TreatmentLog::Implementation::noteEnd() {
  if (has_noted_end || session->end() != SessionEnd::source) return;
  char detail[64];
  std::snprintf(detail, sizeof detail, "%.1f s after the start", session->elapsed_s());
  log.addEvent("recording ended", detail);
  has_noted_end = true;
}

void TreatmentLog::Implementation::run() {
  try {
    while (!is_stopping) {
      const auto state = session->take(std::chrono::milliseconds(50));
      if (state) write(*state);
      writeEvents();
      if (state || !session->hasEnded()) continue;
      noteEnd();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    writeEvents();
    noteEnd();
    log.addEvent("session ended");
    log.sync();
  } catch (const std::exception& error) {
    logWarning(std::string("the session's log stopped: ") + error.what());
    std::lock_guard lock(mutex);
    failure = error.what();
  }
}

TreatmentLog::TreatmentLog(std::shared_ptr<Session> session, const std::filesystem::path& case_folder)
    : implementation_(std::make_unique<Implementation>(std::move(session), case_folder)) {
  implementation_->log.addEvent("session started");
  implementation_->thread = std::thread([i = implementation_.get()] { i->run(); });
}

TreatmentLog::~TreatmentLog() {
  implementation_->is_stopping = true;
  implementation_->thread.join();
}

void TreatmentLog::addEvent(const std::string& event, const std::string& detail) {
  std::lock_guard lock(implementation_->mutex);
  implementation_->events.push_back({event, detail});
}

void TreatmentLog::addPulse() {
  const auto state = implementation_->session->latest();
  std::lock_guard lock(implementation_->mutex);
  implementation_->events.push_back(
      {"pulse", std::to_string(++implementation_->pulses) + ", " + placeOf(state->guidance)});
}

int TreatmentLog::pulses() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->pulses;
}

const std::filesystem::path& TreatmentLog::folder() const { return implementation_->folder; }

std::string TreatmentLog::failure() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->failure;
}

}  // namespace facenav::session
