#pragma once
// A Video4Linux camera of a fake kernel (support/fake_v4l2.h) for the contract tests.

#include "support/camera_contract.h"
#include "support/fake_v4l2.h"

namespace facenav::capture {

using testing::FakeV4l2;
using testing::FakeV4l2Camera;

class V4l2Bench : public testing::CameraBench {
 public:
  explicit V4l2Bench(std::shared_ptr<FakeV4l2> kernel = std::make_shared<FakeV4l2>(),
                     std::string path = "/dev/video0")
      : kernel_(std::move(kernel)), path_(std::move(path)) {
    kernel_->cameras[path_] = camera_;
  }
  std::unique_ptr<Camera> open() override {
    return makeV4l2Backend(kernel_, {})->open({"v4l2", path_, "Fake webcam", "", path_.substr(10)});
  }
  CameraSettings settings() const override {
    CameraSettings settings;
    settings.width_px = 64;
    settings.height_px = 48;
    settings.frames_per_s = 100;
    return settings;
  }
  bool hang(bool is_hung) override { return camera_->is_hung = is_hung, true; }
  bool unplug(bool is_unplugged) override { return camera_->is_unplugged = is_unplugged, true; }
  bool slowDown(double factor) override { return camera_->slowdown = factor, true; }

  FakeV4l2Camera& camera() { return *camera_; }
  FakeV4l2& kernel() { return *kernel_; }
  /// Returns an opened, configured and started camera.
  std::unique_ptr<Camera> running() {
    auto opened = open();
    opened->configure(settings());
    opened->start();
    return opened;
  }

 private:
  std::shared_ptr<FakeV4l2> kernel_;
  std::string path_;
  std::shared_ptr<FakeV4l2Camera> camera_ = std::make_shared<FakeV4l2Camera>();
};

}  // namespace facenav::capture
