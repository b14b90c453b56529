#include "camera_reader.h"

namespace facenav::capture {
namespace {

constexpr double kReadingStep_s = 0.1;  // longest time that a stop waits for the thread

}  // namespace

CameraReader::CameraReader(std::unique_ptr<Camera> camera, std::function<void(CameraPicture)> deliver,
                           std::function<void(std::exception_ptr)> fail)
    : camera_(std::move(camera)),
      identity_(camera_->identity()),
      deliver_(std::move(deliver)),
      fail_(std::move(fail)) {
  note();
  thread_ = std::thread([this] { run(); });
}

CameraReader::~CameraReader() {
  is_stopped_ = true;
  thread_.join();
}

void CameraReader::note() {
  CameraState state = camera_->state();
  const std::lock_guard lock(mutex_);
  state_ = std::move(state);
  counts_ = camera_->counts();
}

void CameraReader::run() {
  try {
    while (!is_stopped_) {
      if (is_trigger_wanted_.exchange(false)) camera_->trigger();
      auto picture = camera_->next(kReadingStep_s);
      note();
      if (picture) deliver_(std::move(*picture));
    }
    camera_->stop();
  } catch (...) {
    fail_(std::current_exception());
  }
}

CameraState CameraReader::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

PictureCounts CameraReader::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

}  // namespace facenav::capture
