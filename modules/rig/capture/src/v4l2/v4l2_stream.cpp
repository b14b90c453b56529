#include "v4l2_stream.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

namespace facenav::capture {
namespace {

constexpr std::uint32_t kBuffers = 4;

v4l2_buffer mappedBuffer(std::uint32_t index) {
  v4l2_buffer buffer = {};
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return buffer;
}

v4l2_requestbuffers bufferRequest(std::uint32_t count) {
  v4l2_requestbuffers request = {};
  request.count = count;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  return request;
}

}  // namespace

V4l2Stream::V4l2Stream(V4l2Device& device) : device_(device) {
  auto request = bufferRequest(kBuffers);
  device_.require(VIDIOC_REQBUFS, &request, "the camera's driver gives no memory for its pictures");
  try {
    mapBuffers(request.count);
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    device_.require(VIDIOC_STREAMON, &type, "the camera does not start");
  } catch (...) {
    release();
    throw;
  }
}

V4l2Stream::~V4l2Stream() {
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  device_.ask(VIDIOC_STREAMOFF, &type);
  release();
}

void V4l2Stream::mapBuffers(std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    v4l2_buffer buffer = mappedBuffer(i);
    device_.require(VIDIOC_QUERYBUF, &buffer, "the camera's driver gives no memory for its pictures");
    void* memory = device_.map(buffer.length, buffer.m.offset);
    if (!memory) device_.fail(ENOMEM, "the camera's pictures cannot be mapped into memory");
    buffers_.emplace_back(memory, buffer.length);
    device_.require(VIDIOC_QBUF, &buffer, "the camera's driver takes no memory for its pictures");
  }
}

/// Releases the buffers: memory must be unmapped before the driver may free it; then another program can use
/// the camera.
void V4l2Stream::release() {
  for (const auto& [memory, length] : buffers_) device_.unmap(memory, length);
  buffers_.clear();
  auto request = bufferRequest(0);
  device_.ask(VIDIOC_REQBUFS, &request);
}

std::optional<V4l2Buffer> V4l2Stream::take(double timeout_s) {
  const int ready = device_.wait(int(std::ceil(1000 * std::max(0.0, timeout_s))));
  if (ready == 0) return std::nullopt;
  if (ready < 0) device_.fail(-ready, "the camera's pictures cannot be waited for");
  v4l2_buffer buffer = mappedBuffer(0);
  const int result = device_.ask(VIDIOC_DQBUF, &buffer);
  if (result == -EAGAIN) return std::nullopt;
  // EIO: a picture was lost on the way; the stream goes on.
  if (result == -EIO)
    return V4l2Buffer{std::uint32_t(buffers_.size()), V4L2_BUF_FLAG_ERROR, 0, 0, nullptr, 0};
  if (result < 0) device_.fail(-result, "the camera gives no picture");
  const auto& [memory, length] = buffers_.at(buffer.index);
  const double stamp_s = double(buffer.timestamp.tv_sec) + 1e-6 * double(buffer.timestamp.tv_usec);
  return V4l2Buffer{buffer.index, buffer.flags, std::int64_t(buffer.sequence),
                    stamp_s,      memory,       std::min<std::size_t>(buffer.bytesused, length)};
}

void V4l2Stream::giveBack(const V4l2Buffer& filled) {
  if (filled.index >= buffers_.size()) return;
  v4l2_buffer buffer = mappedBuffer(filled.index);
  device_.require(VIDIOC_QBUF, &buffer, "the camera's driver takes no memory for its pictures");
}

}  // namespace facenav::capture
