#include "facenav/session/pulse_keeper.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include "facenav/casefile/pulse_file.h"
#include "facenav/casefile/session_so_far.h"
#include "facenav/core/error.h"
#include "facenav/core/log.h"

namespace facenav::session {
namespace {

// Ten seconds at 60 frames/s: a busy window handles a key that much later than it was pressed.
constexpr std::size_t kFramesKept = 600;
constexpr double kRetry_s = 0.5;

struct Waiting {
  PulseTrigger trigger;
  Timestamp added;
};

}  // namespace

struct PulseKeeper::Implementation {
  Implementation(const std::filesystem::path& folder, std::shared_ptr<const registration::ScalpField> scalp_,
                 bool goes_on, Placed placed_)
      : scalp(std::move(scalp_)),
        tell_placed(std::move(placed_)),
        file(folder, goes_on ? casefile::PulseFile::Begin::go_on : casefile::PulseFile::Begin::fresh) {
    if (goes_on) countEarlier(folder);
  }

  const std::shared_ptr<const registration::ScalpField> scalp;
  const Placed tell_placed;  // may be empty

  casefile::PulseFile file;  // used only by the thread
  mutable std::mutex mutex;  // guards the members below, up to `is_stopping`
  std::condition_variable changed;
  std::deque<PosedFrame> frames;          // by the time they were taken
  std::deque<Waiting> pulses;             // in order of arrival
  std::deque<casefile::Pulse> unwritten;  // with their poses
  std::deque<casefile::Pulse> told;       // written, for takeKept()
  std::map<std::string, Timestamp> last_of_source;
  std::string failure;
  Timestamp retry;
  int added = 0, numbered = 0, kept = 0;
  PulseCounts counts;
  std::optional<JudgedPulse> last;
  AddedPulse newest;
  bool is_stopping = false;
  std::thread thread;

  void countEarlier(const std::filesystem::path& folder);
  // All but run() and write() are called with the mutex locked.
  void run();
  void write();
  bool isReady(const Waiting& pulse) const;
  bool isDue() const;
  std::chrono::duration<double> patience() const;
  void placeReady();
  casefile::Pulse placed(const Waiting& pulse);
  void count(const casefile::Pulse& pulse);
};

void PulseKeeper::Implementation::countEarlier(const std::filesystem::path& folder) {
  const auto so_far = casefile::sessionSoFar(folder);
  added = numbered = kept = so_far.last_pulse;
  counts = {so_far.on_target, so_far.outside, so_far.lost};
}

bool PulseKeeper::Implementation::isReady(const Waiting& pulse) const {
  if (is_stopping || Timestamp::now() - pulse.added >= kLongestWait_s) return true;
  return !frames.empty() && frames.back().taken - pulse.trigger.at > 0;
}

bool PulseKeeper::Implementation::isDue() const {
  return !unwritten.empty() && (failure.empty() || is_stopping || Timestamp::now() - retry >= 0);
}

std::chrono::duration<double> PulseKeeper::Implementation::patience() const {
  double wait_s = 60.0;
  if (!pulses.empty()) wait_s = kLongestWait_s - (Timestamp::now() - pulses.front().added);
  if (!unwritten.empty()) wait_s = std::min(wait_s, retry - Timestamp::now());
  return std::chrono::duration<double>(std::max(0.001, wait_s));
}

void PulseKeeper::Implementation::count(const casefile::Pulse& pulse) {
  last = JudgedPulse{pulse.number, pulse.status, pulse.reason};
  ++(pulse.status == casefile::PulseStatus::on_target ? counts.on_target
     : pulse.status == casefile::PulseStatus::outside ? counts.outside
                                                      : counts.lost);
}

casefile::Pulse PulseKeeper::Implementation::placed(const Waiting& pulse) {
  const auto after = std::find_if(frames.begin(), frames.end(), [&](const PosedFrame& frame) {
    return frame.taken - pulse.trigger.at > 0;
  });
  casefile::Pulse result =
      pulseBetween(pulse.trigger, after == frames.begin() ? std::nullopt : std::optional(*std::prev(after)),
                   after == frames.end() ? std::nullopt : std::optional(*after), scalp.get());
  result.number = ++numbered;
  count(result);
  if (tell_placed) tell_placed(result);
  return result;
}

void PulseKeeper::Implementation::placeReady() {
  while (!pulses.empty() && isReady(pulses.front())) {
    unwritten.push_back(placed(pulses.front()));
    pulses.pop_front();
  }
}

/// Writes in order, up to the first pulse that cannot be written. The mutex is free during disk access.
void PulseKeeper::Implementation::write() {
  for (;;) {
    casefile::Pulse pulse;
    {
      std::lock_guard lock(mutex);
      if (unwritten.empty()) return;
      pulse = unwritten.front();
    }
    std::string fault;
    try {
      file.keep(pulse);
    } catch (const std::exception& error) {
      fault = error.what();
    }
    std::lock_guard lock(mutex);
    if (!fault.empty() && failure.empty()) logWarning("a pulse is not kept yet: " + fault);
    failure = fault;
    retry = {Timestamp::now().s + kRetry_s};
    if (!fault.empty()) return;
    told.push_back(std::move(unwritten.front()));
    if (told.size() > kMostTold) told.pop_front();
    unwritten.pop_front();
    ++kept;
  }
}

void PulseKeeper::Implementation::run() {
  for (bool is_last = false; !is_last;) {
    bool is_due = false;
    {
      std::unique_lock lock(mutex);
      if (!is_stopping && !isDue()) changed.wait_for(lock, patience());
      is_last = is_stopping;
      placeReady();
      is_due = isDue();
    }
    if (is_due) write();
  }
  if (!unwritten.empty())
    logWarning(std::to_string(unwritten.size()) + " pulse(s) of the session could not be kept");
}

PulseKeeper::PulseKeeper(const std::filesystem::path& session_folder,
                         std::shared_ptr<const registration::ScalpField> scalp, bool goes_on, Placed placed)
    : implementation_(
          std::make_unique<Implementation>(session_folder, std::move(scalp), goes_on, std::move(placed))) {
  implementation_->thread = std::thread([i = implementation_.get()] { i->run(); });
}

PulseKeeper::~PulseKeeper() {
  {
    std::lock_guard lock(implementation_->mutex);
    implementation_->is_stopping = true;
  }
  implementation_->changed.notify_all();
  implementation_->thread.join();
}

bool PulseKeeper::add(const PulseTrigger& trigger) {
  {
    std::lock_guard lock(implementation_->mutex);
    const auto last = implementation_->last_of_source.find(trigger.source);
    const bool is_known = last != implementation_->last_of_source.end();
    // A trigger slightly out of order is a bounce, too. One dated far back is a pulse whose source's clock
    // has jumped.
    if (is_known && std::abs(trigger.at - last->second) < trigger.dead_time_s) return false;
    implementation_->last_of_source[trigger.source] = trigger.at;
    implementation_->pulses.push_back({trigger, Timestamp::now()});
    implementation_->placeReady();
    implementation_->newest = {++implementation_->added, trigger.intensity_pct};
  }
  implementation_->changed.notify_all();
  return true;
}

void PulseKeeper::follow(const NavigationState& state) {
  if (state.frame < 0) return;
  {
    std::lock_guard lock(implementation_->mutex);
    auto& frames = implementation_->frames;
    if (!frames.empty() && state.taken - frames.back().taken <= 0) return;  // the last state again
    frames.push_back(posedFrame(state));
    if (frames.size() > kFramesKept) frames.pop_front();
    if (implementation_->pulses.empty()) return;
    implementation_->placeReady();
  }
  implementation_->changed.notify_all();
}

PulseCounts PulseKeeper::counts() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->counts;
}

std::optional<JudgedPulse> PulseKeeper::last() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->last;
}

int PulseKeeper::added() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->added;
}

AddedPulse PulseKeeper::newest() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->newest;
}

int PulseKeeper::kept() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->kept;
}

std::vector<casefile::Pulse> PulseKeeper::takeKept() {
  std::lock_guard lock(implementation_->mutex);
  std::vector<casefile::Pulse> taken(std::make_move_iterator(implementation_->told.begin()),
                                     std::make_move_iterator(implementation_->told.end()));
  implementation_->told.clear();
  return taken;
}

int PulseKeeper::waiting() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->added - implementation_->kept;
}

std::string PulseKeeper::failure() const {
  std::lock_guard lock(implementation_->mutex);
  return implementation_->failure;
}

}  // namespace facenav::session
