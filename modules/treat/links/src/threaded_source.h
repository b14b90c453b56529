#pragma once
// ThreadedSource: a pulse source with a thread of its own that waits on descriptors and can be woken to stop.

#include <poll.h>

#include <atomic>
#include <optional>
#include <thread>
#include <vector>

#include "facenav/links/pulse_source.h"

namespace facenav::links {

/// Largest delay of a pulse's arrival. An older time stamp comes from a clock that jumped or is unknown.
constexpr double kOldestPulse_s = 1.0;

/// Each source stops itself in its own destructor, while its run() still exists.
class ThreadedSource : public PulseSource {
 public:
  ThreadedSource(std::string name, double dead_time_s) : name_(std::move(name)), dead_time_s_(dead_time_s) {}
  std::string name() const override { return name_; }
  void start(PulseListener listener) override;
  void stop() override;

 protected:
  /// Opens the source, on the caller's thread; throws Error.
  virtual void open() = 0;
  /// Reads the source, on its own thread, until isStopping().
  virtual void run() = 0;
  /// Closes the source, after run() or when open() threw.
  virtual void close() = 0;

  bool isStopping() const { return is_stopping_; }
  /// Waits until one of the descriptors is ready, `wait_ms` have passed (-1: no limit) or stop() was called.
  void waitFor(std::vector<pollfd>& descriptors, int wait_ms) const;
  void waitFor(int wait_ms) const;
  /// Reports a pulse `age_s` ago; `coil`: as in PulseTrigger.
  void tellPulse(double age_s = 0, std::optional<double> intensity_pct = {},
                 const std::string& coil = {}) const;
  /// Reports a problem, only if the words differ from the last ones.
  void tellProblem(const std::string& words);

 private:
  std::string name_;
  double dead_time_s_;
  PulseListener listener_;
  std::string told_;
  std::atomic<bool> is_stopping_{false};
  int wake_[2] = {-1, -1};
  std::thread thread_;
};

}  // namespace facenav::links
