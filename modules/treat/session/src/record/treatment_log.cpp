#include "facenav/session/treatment_log.h"

#include <algorithm>

#include "facenav/casefile/session_pulses.h"
#include "facenav/core/number_text.h"
#include "log_threads.h"

namespace facenav::session {

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
