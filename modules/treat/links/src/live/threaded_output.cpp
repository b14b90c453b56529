#include "threaded_output.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "facenav/core/error.h"
#include "facenav/core/log.h"

namespace facenav::links {
namespace {

constexpr std::size_t kMostPulses = 64;
constexpr int kRound_ms = 50;  // stale frames and silent receivers are looked for so often

}  // namespace

LiveFrame withoutPoses(const LiveFrame& frame, const std::string& status) {
  LiveFrame lost = frame;
  for (auto& each : lost.poses) each.pose.reset(), each.status = status;
  lost.state = "lost";
  lost.instruction.clear();
  lost.guidance.reset();
  return lost;
}

void ThreadedOutput::publish(std::shared_ptr<const LiveFrame> frame) {
  {
    std::lock_guard lock(mutex_);
    if (next_) ++report_.replaced;
    next_ = std::move(frame);
  }
  wake();
}

void ThreadedOutput::publish(const PulseTrigger& pulse) {
  {
    std::lock_guard lock(mutex_);
    if (pulses_.size() < kMostPulses) pulses_.push_back(pulse);
  }
  wake();
}

LiveReport ThreadedOutput::report() const {
  std::lock_guard lock(mutex_);
  return report_;
}

void ThreadedOutput::start() {
  wake_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (wake_ < 0) throw Error("no event can be made", name_, "close other programs");
  is_stopping_ = false;
  thread_ = std::thread([this] {
    try {
      while (!is_stopping_) work();
    } catch (const std::exception& error) {  // an exception in a thread must not end the program
      logWarning("output " + name_ + " stopped: " + error.what());
    }
  });
}

void ThreadedOutput::stop() {
  if (!thread_.joinable()) return;
  is_stopping_ = true;
  wake();
  thread_.join();
  auto last = takeFrame();
  if (!last) last = last_;
  if (last) {
    LiveFrame lost = withoutPoses(*last, "MISSING");
    lost.utc = std::max(lost.utc, std::chrono::system_clock::now());
    finish(lost);
  }
  ::close(std::exchange(wake_, -1));
}

void ThreadedOutput::wake() const {
  const std::uint64_t one = 1;
  if (wake_ >= 0) (void)!::write(wake_, &one, sizeof one);
}

void ThreadedOutput::waitFor(std::vector<pollfd>& descriptors) {
  descriptors.push_back({wake_, POLLIN, 0});
  ::poll(descriptors.data(), descriptors.size(), kRound_ms);
  std::uint64_t ignored;
  if (descriptors.back().revents != 0) (void)!::read(wake_, &ignored, sizeof ignored);
  descriptors.pop_back();
}

std::shared_ptr<const LiveFrame> ThreadedOutput::takeFrame() {
  std::shared_ptr<const LiveFrame> frame;
  {
    std::lock_guard lock(mutex_);
    frame = std::exchange(next_, nullptr);
  }
  if (frame) {
    last_ = frame;
    taken_ = Timestamp::now();
    return frame;
  }
  if (!last_ || Timestamp::now() - taken_ < kStaleFrame_s) return nullptr;
  const bool has_pose =
      std::any_of(last_->poses.begin(), last_->poses.end(), [](const auto& each) { return each.pose; });
  if (!has_pose) return nullptr;
  auto lost = std::make_shared<LiveFrame>(withoutPoses(*last_, "MISSING"));
  lost->utc = std::max(lost->utc, std::chrono::system_clock::now());  // receivers ignore older times
  last_ = lost;
  return lost;
}

std::deque<PulseTrigger> ThreadedOutput::takePulses() {
  std::lock_guard lock(mutex_);
  return std::exchange(pulses_, {});
}

void ThreadedOutput::setReceivers(std::vector<std::string> receivers) {
  std::lock_guard lock(mutex_);
  report_.receivers = std::move(receivers);
}

void ThreadedOutput::count(std::uint64_t sent, std::uint64_t dropped, std::size_t waiting) {
  std::lock_guard lock(mutex_);
  report_.sent += sent;
  report_.dropped += dropped;
  report_.most_waiting = std::max(report_.most_waiting, waiting);
}

}  // namespace facenav::links
