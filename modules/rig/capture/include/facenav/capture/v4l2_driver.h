#pragma once
// V4l2Driver: the system calls of the Video4Linux backend, so that tests can replace the kernel. Results are
// those of the system calls, with -errno in place of -1.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "facenav/capture/camera_backend.h"

namespace facenav::capture {

class V4l2Driver {
 public:
  virtual ~V4l2Driver() = default;
  virtual int open(const std::string& path) = 0;
  virtual void close(int device) = 0;
  virtual int control(int device, unsigned long request, void* argument) = 0;  // ioctl
  /// Maps a buffer; null if it fails.
  virtual void* map(int device, std::size_t length, std::size_t offset) = 0;
  virtual void unmap(void* address, std::size_t length) = 0;
  /// Waits. > 0: a picture is ready, or an error is to be read; 0: none within the time.
  virtual int wait(int device, int timeout_ms) = 0;
};

std::shared_ptr<V4l2Driver> makeSystemV4l2Driver();

/// Paths where the system lists its cameras. `sys`: one folder a device with its name; its link `device`
/// leads to the USB device. `proc`: one folder a process with its open files.
struct V4l2Places {
  std::filesystem::path sys = "/sys/class/video4linux", dev = "/dev", proc = "/proc";
};

std::unique_ptr<CameraBackend> makeV4l2Backend(std::shared_ptr<V4l2Driver> driver, const V4l2Places& places);

}  // namespace facenav::capture
