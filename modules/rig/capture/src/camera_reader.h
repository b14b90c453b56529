#pragma once
// CameraReader: reads a started camera on its own thread, so that no picture waits in the driver.

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "facenav/capture/camera.h"

namespace facenav::capture {

class CameraReader {
 public:
  /// `deliver` and `fail` are called on the reading thread; after `fail` no more pictures come.
  CameraReader(std::unique_ptr<Camera> camera, std::function<void(CameraPicture)> deliver,
               std::function<void(std::exception_ptr)> fail);
  /// Stops the camera and releases it.
  ~CameraReader();
  CameraReader(const CameraReader&) = delete;
  CameraReader& operator=(const CameraReader&) = delete;

  const CameraIdentity& identity() const { return identity_; }
  /// State as of the newest picture.
  CameraState state() const;
  PictureCounts counts() const;
  /// Asks the camera for one picture, soon after (Trigger::software).
  void requestTrigger() { is_trigger_wanted_ = true; }

 private:
  void run();
  void note();
  std::unique_ptr<Camera> camera_;
  const CameraIdentity identity_;
  std::function<void(CameraPicture)> deliver_;
  std::function<void(std::exception_ptr)> fail_;
  mutable std::mutex mutex_;
  CameraState state_;
  PictureCounts counts_;
  std::atomic<bool> is_stopped_{false}, is_trigger_wanted_{false};
  std::thread thread_;
};

}  // namespace facenav::capture
