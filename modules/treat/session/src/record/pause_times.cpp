#include "facenav/session/pause_times.h"

#include <algorithm>

namespace facenav::session {

PauseTimes::PauseTimes(bool is_paused) {
  if (is_paused) pauses_.push_back({Timestamp::now(), {}});
}

bool PauseTimes::begin(const std::string& reason, Timestamp at) {
  std::lock_guard lock(mutex_);
  if (isUnderWay()) return false;
  pauses_.push_back({at, {}});
  reason_ = reason;
  return true;
}

std::optional<double> PauseTimes::end(Timestamp at) {
  std::lock_guard lock(mutex_);
  if (!isUnderWay()) return std::nullopt;
  pauses_.back().to = at;
  reason_.clear();
  return std::max(0.0, at - pauses_.back().from);
}

bool PauseTimes::isPaused() const {
  std::lock_guard lock(mutex_);
  return isUnderWay();
}

std::string PauseTimes::reason() const {
  std::lock_guard lock(mutex_);
  return reason_;
}

double PauseTimes::length_s() const {
  std::lock_guard lock(mutex_);
  return isUnderWay() ? Timestamp::now() - pauses_.back().from : 0.0;
}

bool PauseTimes::holds(Timestamp at) const {
  std::lock_guard lock(mutex_);
  return std::any_of(pauses_.begin(), pauses_.end(), [&](const Pause& pause) {
    return at - pause.from >= 0 && (!pause.to || at - *pause.to < 0);
  });
}

double PauseTimes::total_s(Timestamp until) const {
  std::lock_guard lock(mutex_);
  double total_s = 0;
  for (const Pause& pause : pauses_) {
    const double to_s = pause.to ? std::min(pause.to->s, until.s) : until.s;
    total_s += std::max(0.0, to_s - pause.from.s);
  }
  return total_s;
}

}  // namespace facenav::session
