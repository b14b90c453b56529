#include "facenav/capture/live_preview.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <mutex>
#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/latest_value.h"

namespace facenav::capture {
namespace {

constexpr double kRateOver_s = 1.0, kLongestWait_s = 1.0;

}  // namespace

struct LivePreview::Implementation {
  std::unique_ptr<FrameSource> source;
  bool is_paced;
  LatestValue<cameras::StereoFrame> newest;
  mutable std::mutex mutex;
  std::deque<double> arrivals_s;
  std::string failure;
  std::atomic<bool> has_ended{false}, is_stopped{false};
  std::thread thread;

  void run();
  void waitFor(double captured_s, double first_captured_s, double begun_s) const;
  void noteArrival();
};

/// Waits in short steps, so that a stop takes effect quickly.
void LivePreview::Implementation::waitFor(double captured_s, double first_captured_s, double begun_s) const {
  const double due_s = std::min(begun_s + captured_s - first_captured_s, Timestamp::now().s + kLongestWait_s);
  while (!is_stopped && Timestamp::now().s < due_s)
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(0.02, due_s - Timestamp::now().s)));
}

void LivePreview::Implementation::noteArrival() {
  const double now_s = Timestamp::now().s;
  const std::lock_guard lock(mutex);
  arrivals_s.push_back(now_s);
  while (arrivals_s.front() < now_s - kRateOver_s) arrivals_s.pop_front();
}

void LivePreview::Implementation::run() {
  try {
    const double begun_s = Timestamp::now().s;
    std::optional<double> first_s;
    while (!is_stopped) {
      auto frame = source->next();
      if (!frame) break;
      if (!first_s) first_s = frame->captured.s;
      if (is_paced) waitFor(frame->captured.s, *first_s, begun_s);
      newest.publish(std::move(frame));
      noteArrival();
    }
  } catch (const std::exception& error) {
    const std::lock_guard lock(mutex);
    failure = error.what();
  }
  has_ended = true;
}

LivePreview::LivePreview(std::unique_ptr<FrameSource> source, bool is_paced)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->source = std::move(source);
  implementation_->is_paced = is_paced;
  implementation_->thread = std::thread([this] { implementation_->run(); });
}

LivePreview::~LivePreview() {
  implementation_->is_stopped = true;
  implementation_->thread.join();
}

std::shared_ptr<const cameras::StereoFrame> LivePreview::latest() const {
  return implementation_->newest.latest();
}

double LivePreview::age_s() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->arrivals_s.empty() ? 1e9 : Timestamp::now().s - implementation_->arrivals_s.back();
}

double LivePreview::frames_per_s() const {
  const std::lock_guard lock(implementation_->mutex);
  const auto& arrivals_s = implementation_->arrivals_s;
  if (arrivals_s.size() < 2) return 0.0;
  return double(arrivals_s.size() - 1) / std::max(1e-3, arrivals_s.back() - arrivals_s.front());
}

std::string LivePreview::failure() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->failure;
}

std::vector<std::string> LivePreview::cautions() const { return implementation_->source->cautions(); }

bool LivePreview::hasEnded() const { return implementation_->has_ended; }

}  // namespace facenav::capture
