#pragma once
// V4l2Stream: the memory-mapped buffers of a Video4Linux camera while it runs.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "v4l2_device.h"

namespace facenav::capture {

/// A filled buffer. Give it back with V4l2Stream::giveBack.
struct V4l2Buffer {
  std::uint32_t index = 0, flags = 0;
  std::int64_t sequence = 0;
  double stamp_s = 0.0;
  const void* bytes = nullptr;
  std::size_t size = 0;
};

class V4l2Stream {
 public:
  /// Maps the buffers and starts the camera. Throws CameraError: in_use, no_bandwidth, unplugged.
  explicit V4l2Stream(V4l2Device& device);
  ~V4l2Stream();
  V4l2Stream(const V4l2Stream&) = delete;
  V4l2Stream& operator=(const V4l2Stream&) = delete;

  /// Takes the oldest filled buffer; nullopt if none comes within the time. Throws CameraError unplugged.
  std::optional<V4l2Buffer> take(double timeout_s);
  void giveBack(const V4l2Buffer& buffer);

 private:
  void mapBuffers(std::uint32_t count);
  void release();
  V4l2Device& device_;
  std::vector<std::pair<void*, std::size_t>> buffers_;
};

}  // namespace facenav::capture
