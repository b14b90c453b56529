#pragma once
// Picture format of a Video4Linux camera: choice, size and rate, and the decoding into grey.

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "facenav/capture/camera.h"
#include "v4l2_device.h"

namespace facenav::capture {

struct V4l2Format {
  std::uint32_t code = 0;  // V4L2_PIX_FMT_GREY, _YUYV or _MJPEG
  int width_px = 0, height_px = 0, bytes_a_row = 0;
  double frames_per_s = 0.0;  // 0: unknown to the driver
};

std::string formatName(std::uint32_t code);
/// Sets format, size and rate; returns the driver's actual choice. Throws CameraError wrong_size, naming the
/// sizes that the camera has; in_use.
V4l2Format setFormat(V4l2Device& device, const CameraSettings& settings, const std::string& camera);
/// Decodes to 8-bit grey, own memory; empty if the bytes are no whole picture.
cv::Mat decodeGrey(const V4l2Format& format, const void* bytes, std::size_t size);

}  // namespace facenav::capture
