#pragma once
// Dc1394Driver: the calls of the IEEE 1394 (FireWire, IIDC) backend to libdc1394, so that tests can replace
// the bus and its cameras.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/capture/camera_backend.h"

namespace facenav::capture {

struct Dc1394Unit {
  std::uint64_t guid = 0;  // worldwide number of the camera
  std::string vendor, model;
};

/// A picture format of the camera. `rates`: pictures a second.
struct Dc1394Mode {
  int id = 0, width_px = 0, height_px = 0;
  bool is_yuv422 = false;  // U Y V Y; else grey, a byte a pixel
  std::vector<double> rates;
};

/// An adjustment, in its unit if the camera has one (shutter s), else in the camera's steps.
struct Dc1394Adjustment {
  double minimum = 0, maximum = 0, value = 0;
  bool is_automatic = false, has_unit = false;
};
enum class Dc1394Feature { shutter, gain, focus };

enum class Dc1394Answer { done, busy, no_bandwidth, gone, refused };

struct Dc1394Picture {
  const std::uint8_t* bytes = nullptr;  // valid until giveBack()
  std::size_t stride = 0;               // bytes a line
  double unix_s = 0;                    // arrival over the bus, seconds since 1970
  bool is_damaged = false;
};

class Dc1394Device {
 public:
  virtual ~Dc1394Device() = default;
  virtual std::vector<Dc1394Mode> modes() = 0;
  virtual Dc1394Answer setMode(const Dc1394Mode& mode, double rate) = 0;
  /// Reads an adjustment; nullopt if the camera has none.
  virtual std::optional<Dc1394Adjustment> read(Dc1394Feature feature) = 0;
  virtual void write(Dc1394Feature feature, bool is_automatic, std::optional<double> value) = 0;
  virtual Dc1394Answer setTrigger(Trigger trigger) = 0;
  virtual Dc1394Answer pullTrigger() = 0;
  virtual Dc1394Answer start() = 0;
  virtual void stop() = 0;
  /// Waits for a picture; nullopt if none came within the time, or if `is_gone` is set.
  virtual std::optional<Dc1394Picture> take(double timeout_s, bool& is_gone) = 0;
  virtual void giveBack() = 0;
};

class Dc1394Driver {
 public:
  virtual ~Dc1394Driver() = default;
  /// Lists the cameras; empty if there is no bus.
  virtual std::vector<Dc1394Unit> list() = 0;
  /// Opens a camera; null if it cannot be opened.
  virtual std::unique_ptr<Dc1394Device> open(std::uint64_t guid) = 0;
};

std::unique_ptr<CameraBackend> makeDc1394Backend(std::shared_ptr<Dc1394Driver> driver);

}  // namespace facenav::capture
