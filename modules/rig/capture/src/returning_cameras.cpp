#include "facenav/capture/returning_cameras.h"

#include <future>
#include <mutex>
#include <thread>

#include "facenav/capture/camera.h"

namespace facenav::capture {
namespace {

constexpr double kTellEvery_s = 0.1;   // between reports of absence; a session takes older ones for stale
constexpr double kRetryEvery_s = 0.3;  // interval between attempts to open them

bool mayComeBack(CameraFault fault) {
  return fault != CameraFault::ended && fault != CameraFault::wrong_size;
}

class ReturningCameras : public FrameSource {
 public:
  explicit ReturningCameras(std::function<std::unique_ptr<FrameSource>()> open)
      : open_(std::move(open)), cameras_(open_()), rig_(cameras_->rig()) {}
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override;
  std::vector<std::string> cautions() const override;

 private:
  std::shared_ptr<const cameras::StereoFrame> absent();
  void tryToOpen();

  const std::function<std::unique_ptr<FrameSource>()> open_;
  mutable std::mutex mutex_;  // guards cameras_ against cautions()
  std::shared_ptr<FrameSource> cameras_;
  const cameras::StereoRig rig_;
  std::string absence_;  // reason why no pictures come; empty: they come
  std::int64_t number_ = 0;
  double last_s_ = -1e300;
  /// Runs on a thread of its own, because closing a camera that is gone, and opening one, take seconds.
  std::future<std::shared_ptr<FrameSource>> opening_;
};

std::shared_ptr<const cameras::StereoFrame> ReturningCameras::next() {
  if (!absence_.empty()) {
    std::this_thread::sleep_for(std::chrono::duration<double>(kTellEvery_s));
    tryToOpen();
    if (!cameras_) return absent();
  }
  try {
    for (;;) {
      const auto frame = cameras_->next();
      if (!frame) return nullptr;
      if (frame->captured.s <= last_s_) continue;  // older than the last report of their absence
      absence_.clear();
      auto numbered = std::make_shared<cameras::StereoFrame>(*frame);
      numbered->number = number_++;
      last_s_ = frame->captured.s;
      return numbered;
    }
  } catch (const CameraError& error) {
    if (!mayComeBack(error.fault())) throw;
    absence_ = error.what();
    return absent();
  }
}

std::shared_ptr<const cameras::StereoFrame> ReturningCameras::absent() {
  auto frame = std::make_shared<cameras::StereoFrame>();
  frame->number = number_++;
  frame->captured = Timestamp::now();
  frame->absence = absence_;
  last_s_ = frame->captured.s;
  return frame;
}

void ReturningCameras::tryToOpen() {
  if (!opening_.valid()) {
    std::shared_ptr<FrameSource> old;
    {
      const std::lock_guard lock(mutex_);
      old.swap(cameras_);
    }
    opening_ = std::async(std::launch::async, [this, old = std::move(old)]() mutable {
      old.reset();  // first: a camera can be opened only once
      std::this_thread::sleep_for(std::chrono::duration<double>(kRetryEvery_s));
      return std::shared_ptr<FrameSource>(open_());
    });
  }
  if (opening_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  try {
    std::shared_ptr<FrameSource> opened = opening_.get();
    const std::lock_guard lock(mutex_);
    cameras_ = std::move(opened);
  } catch (const CameraError& error) {
    if (!mayComeBack(error.fault())) throw;
    absence_ = error.what();
  }
}

std::vector<std::string> ReturningCameras::cautions() const {
  std::shared_ptr<FrameSource> cameras;
  {
    const std::lock_guard lock(mutex_);
    cameras = cameras_;
  }
  return cameras ? cameras->cautions() : std::vector<std::string>();
}

}  // namespace

std::unique_ptr<FrameSource> makeReturningCameras(std::function<std::unique_ptr<FrameSource>()> open) {
  return std::make_unique<ReturningCameras>(std::move(open));
}

}  // namespace facenav::capture
