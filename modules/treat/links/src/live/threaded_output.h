#pragma once
// ThreadedOutput: an output with a thread of its own. It takes the newest frame only; when no frame has come
// for a quarter of a second it makes one itself in which every pose is lost, so that no receiver keeps an
// old pose.

#include <poll.h>

#include <atomic>
#include <deque>
#include <mutex>
#include <thread>

#include "facenav/core/timestamp.h"
#include "facenav/links/live_output.h"

namespace facenav::links {

/// Age at which the last frame's poses are lost, as in a session.
constexpr double kStaleFrame_s = 0.25;

/// Each output stops itself in its own destructor, while its functions still exist.
class ThreadedOutput : public LiveOutput {
 public:
  explicit ThreadedOutput(std::string name) : name_(std::move(name)) {}
  std::string name() const override { return name_; }
  void publish(std::shared_ptr<const LiveFrame> frame) override;
  void publish(const PulseTrigger& pulse) override;
  LiveReport report() const override;

 protected:
  /// Starts the thread, which calls work() until stop().
  void start();
  /// Ends the thread and calls finish() with a frame without poses. Safe to call twice.
  void stop();
  /// Does one round: waits, receives, sends. Runs on the output's thread.
  virtual void work() = 0;
  /// Sends the last frame, in which every pose is lost. Runs on the thread that stops the output.
  virtual void finish(const LiveFrame& frame) = 0;

  /// Waits until a descriptor is ready, a frame or pulse came, or a frame has become stale.
  void waitFor(std::vector<pollfd>& descriptors);
  /// Wakes waitFor(), from any thread.
  void wake() const;
  /// New frame, or the one without poses after the last has become stale; null: none.
  std::shared_ptr<const LiveFrame> takeFrame();
  std::deque<PulseTrigger> takePulses();
  /// Replaces the report's receivers and adds to its numbers.
  void setReceivers(std::vector<std::string> receivers);
  void count(std::uint64_t sent, std::uint64_t dropped, std::size_t waiting);

 private:
  std::string name_;
  mutable std::mutex mutex_;  // guards the members below; held only for a swap
  std::shared_ptr<const LiveFrame> next_;
  std::deque<PulseTrigger> pulses_;
  LiveReport report_;
  // The next members belong to the thread.
  std::shared_ptr<const LiveFrame> last_;
  Timestamp taken_;
  std::atomic<bool> is_stopping_{false};
  int wake_ = -1;
  std::thread thread_;
};

}  // namespace facenav::links
