#include "facenav/treat/pulse_fields.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "facenav/casefile/session_pulses.h"
#include "facenav/core/later_answer.h"
#include "facenav/core/log.h"
#include "facenav/efield/coil_file.h"

namespace facenav::steps {

std::string fieldCoilName(const std::string& coil) { return std::filesystem::path(coil).filename().string(); }

std::optional<casefile::PulseField> fieldOfPulse(const PoseFields& fields, const std::string& coil,
                                                 const casefile::Pulse& pulse) {
  const auto pose = pulse.mri_T_coil();
  if (!pose) return std::nullopt;
  const auto computed =
      fields.at(*pose, pulse.target ? std::optional(pulse.target->cortex_point) : std::nullopt);
  casefile::PulseField result;
  result.coil = fieldCoilName(coil);
  result.tier = int(fields.tier());
  result.at_target = computed.at_target;
  result.peak = computed.peak;
  result.peak_place = computed.peak_place;
  const double largest = fields.coil().largest_didt_A_per_us;
  if (pulse.intensity_pct && largest > 0) result.rate_A_per_us = largest * *pulse.intensity_pct / 100;
  return result;
}

int computePulseFields(const casefile::CaseStore& store, const std::filesystem::path& session_folder,
                       const std::string& coil, TaskMonitor& monitor) {
  const auto session = casefile::readSessionPulses(session_folder);
  const PoseFields fields(std::make_shared<const ReadHead>(store), efield::fieldCoil(coil).dipoles);
  std::map<int, casefile::PulseField> computed;
  for (std::size_t i = 0; i < session.pulses.size(); ++i) {
    monitor.report("electric field of the pulses", double(i) / double(session.pulses.size()));
    const auto& pulse = session.pulses[i].pulse;
    if (auto field = fieldOfPulse(fields, coil, pulse)) computed.emplace(pulse.number, std::move(*field));
  }
  casefile::keepPulseFields(session_folder, computed);
  return int(computed.size());
}

struct PulseFieldKeeper::Implementation {
  Implementation(const casefile::CaseStore& store_, const std::filesystem::path& folder_,
                 const std::string& coil_)
      : store(store_), folder(folder_), coil(coil_) {}

  const casefile::CaseStore store;
  const std::filesystem::path folder;
  const std::string coil;
  std::unique_ptr<PoseFields> fields;  // used only by the thread; null until the first pulse
  mutable std::mutex mutex;            // guards the members below
  std::condition_variable changed;
  std::deque<casefile::Pulse> waiting;
  std::string failure;
  bool is_stopping = false;
  std::thread thread;

  void run();
  bool keep(const std::deque<casefile::Pulse>& pulses);
};

/// Computes and writes several pulses. Returns false, and notes why, if no field can be computed.
bool PulseFieldKeeper::Implementation::keep(const std::deque<casefile::Pulse>& pulses) {
  try {
    if (!fields)
      fields = std::make_unique<PoseFields>(std::make_shared<const ReadHead>(store),
                                            efield::fieldCoil(coil).dipoles);
    std::map<int, casefile::PulseField> computed;
    for (const auto& pulse : pulses)
      if (auto field = fieldOfPulse(*fields, coil, pulse)) computed.emplace(pulse.number, std::move(*field));
    casefile::keepPulseFields(folder, computed);
    return true;
  } catch (
      const std::exception& error) {  // the session goes on; 'facenav pulses --field' computes them later
    logWarning(std::string("the electric field of the pulses is not kept: ") + error.what());
    const std::lock_guard lock(mutex);
    failure = error.what();
    return fields != nullptr;  // a full disk passes; a case without a brain does not
  }
}

void PulseFieldKeeper::Implementation::run() {
  runInBackground();
  for (bool can_compute = true;;) {
    std::deque<casefile::Pulse> pulses;
    {
      std::unique_lock lock(mutex);
      changed.wait(lock, [this] { return is_stopping || !waiting.empty(); });
      pulses.swap(waiting);
      if (pulses.empty()) return;  // stopping
    }
    if (can_compute) can_compute = keep(pulses);
  }
}

PulseFieldKeeper::PulseFieldKeeper(const casefile::CaseStore& store,
                                   const std::filesystem::path& session_folder, const std::string& coil)
    : implementation_(std::make_unique<Implementation>(store, session_folder, coil)) {
  implementation_->thread = std::thread([i = implementation_.get()] { i->run(); });
}

PulseFieldKeeper::~PulseFieldKeeper() {
  {
    const std::lock_guard lock(implementation_->mutex);
    implementation_->is_stopping = true;
  }
  implementation_->changed.notify_all();
  implementation_->thread.join();
}

void PulseFieldKeeper::add(const casefile::Pulse& pulse) {
  {
    const std::lock_guard lock(implementation_->mutex);
    implementation_->waiting.push_back(pulse);
  }
  implementation_->changed.notify_all();
}

std::string PulseFieldKeeper::failure() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->failure;
}

}  // namespace facenav::steps
