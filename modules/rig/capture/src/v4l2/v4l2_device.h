#pragma once
// V4l2Device: an open Video4Linux device; closes it. Turns the driver's error numbers into CameraErrors.

#include <memory>
#include <optional>
#include <string>

#include "facenav/capture/v4l2_driver.h"

namespace facenav::capture {

class V4l2Device {
 public:
  /// Opens the device. Throws CameraError: missing, in_use, no_permission, refused (it takes no pictures).
  V4l2Device(std::shared_ptr<V4l2Driver> driver, const CameraIdentity& camera);
  ~V4l2Device();
  V4l2Device(const V4l2Device&) = delete;
  V4l2Device& operator=(const V4l2Device&) = delete;

  /// The driver's answer: >= 0, or -errno.
  int ask(unsigned long request, void* argument) { return driver_->control(device_, request, argument); }
  /// Sends a request; throws CameraError if the driver refuses. `what`: "the camera does not start".
  void require(unsigned long request, void* argument, const std::string& what);
  int wait(int timeout_ms) { return driver_->wait(device_, timeout_ms); }
  void* map(std::size_t length, std::size_t offset) { return driver_->map(device_, length, offset); }
  void unmap(void* address, std::size_t length) { driver_->unmap(address, length); }
  [[noreturn]] void fail(int error, const std::string& what) const;

 private:
  void requirePictures();
  std::shared_ptr<V4l2Driver> driver_;
  std::string where_;
  int device_ = -1;
};

}  // namespace facenav::capture
