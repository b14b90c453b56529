#include "v4l2_format.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <vector>

#include "facenav/core/number_text.h"

namespace facenav::capture {
namespace {

constexpr std::uint32_t kCapture = V4L2_BUF_TYPE_VIDEO_CAPTURE;
// Known formats in the order of preference: without loss first.
constexpr std::array<std::uint32_t, 3> kKnownFormats = {V4L2_PIX_FMT_GREY, V4L2_PIX_FMT_YUYV,
                                                        V4L2_PIX_FMT_MJPEG};
constexpr double kEnough = 0.95;  // share of the wanted rate
constexpr std::uint32_t kMostEntries =
    256;  // most entries of any list: a driver that never ends its list must not hang us

std::set<std::uint32_t> formatsOf(V4l2Device& device) {
  std::set<std::uint32_t> codes;
  v4l2_fmtdesc entry = {};
  entry.type = kCapture;
  for (; entry.index < kMostEntries && device.ask(VIDIOC_ENUM_FMT, &entry) >= 0; ++entry.index)
    codes.insert(entry.pixelformat);
  return codes;
}

bool isInRange(const v4l2_frmsize_stepwise& range, std::uint32_t width, std::uint32_t height) {
  const auto fits = [](std::uint32_t value, std::uint32_t least, std::uint32_t most, std::uint32_t step) {
    return value >= least && value <= most && (value - least) % std::max(1u, step) == 0;
  };
  return fits(width, range.min_width, range.max_width, range.step_width) &&
         fits(height, range.min_height, range.max_height, range.step_height);
}

/// True if a format has the size (or if the driver has no list); `sizes` gathers the sizes for the message.
bool hasSize(V4l2Device& device, std::uint32_t code, const CameraSettings& settings,
             std::set<std::string>& sizes) {
  const auto width = std::uint32_t(settings.width_px), height = std::uint32_t(settings.height_px);
  v4l2_frmsizeenum entry = {};
  entry.pixel_format = code;
  bool is_found = false;
  for (; entry.index < kMostEntries && device.ask(VIDIOC_ENUM_FRAMESIZES, &entry) >= 0; ++entry.index) {
    if (entry.type != V4L2_FRMSIZE_TYPE_DISCRETE) return isInRange(entry.stepwise, width, height);
    sizes.insert(std::to_string(entry.discrete.width) + " x " + std::to_string(entry.discrete.height));
    is_found |= entry.discrete.width == width && entry.discrete.height == height;
  }
  return is_found || entry.index == 0;
}

double rate(const v4l2_fract& interval) {
  return interval.numerator == 0 ? 0.0 : double(interval.denominator) / double(interval.numerator);
}

/// The highest rate of a format at this size; the wanted one if the driver has no list.
double highestRate(V4l2Device& device, std::uint32_t code, const CameraSettings& settings) {
  v4l2_frmivalenum entry = {};
  entry.pixel_format = code;
  entry.width = std::uint32_t(settings.width_px);
  entry.height = std::uint32_t(settings.height_px);
  double highest = 0.0;
  for (; entry.index < kMostEntries && device.ask(VIDIOC_ENUM_FRAMEINTERVALS, &entry) >= 0; ++entry.index) {
    if (entry.type != V4L2_FRMIVAL_TYPE_DISCRETE) return rate(entry.stepwise.min);
    highest = std::max(highest, rate(entry.discrete));
  }
  return entry.index == 0 ? settings.frames_per_s : highest;
}

std::string joined(const std::set<std::string>& words) {
  std::string all;
  for (const auto& word : words) all += (all.empty() ? "" : ", ") + word;
  return all.empty() ? "none" : all;
}

CameraError wrongSize(const CameraSettings& settings, const std::string& camera, const std::string& remedy) {
  return CameraError(CameraFault::wrong_size,
                     "the camera gives no pictures of " + std::to_string(settings.width_px) + " x " +
                         std::to_string(settings.height_px) + " px" +
                         (settings.format.empty() ? "" : " in the format " + settings.format),
                     camera, remedy);
}

std::uint32_t chooseFormat(V4l2Device& device, const CameraSettings& settings, const std::string& camera) {
  const auto offered = formatsOf(device);
  std::set<std::string> sizes;
  std::uint32_t best = 0;
  double best_rate = -1.0;
  for (std::uint32_t code : kKnownFormats) {
    if (!offered.count(code) || (!settings.format.empty() && formatName(code) != settings.format)) continue;
    if (!hasSize(device, code, settings, sizes)) continue;
    const double highest = std::min(highestRate(device, code, settings), kEnough * settings.frames_per_s);
    if (highest <= best_rate) continue;
    best = code;
    best_rate = highest;
  }
  if (best_rate < 0)
    throw wrongSize(settings, camera, "it has " + joined(sizes) + "; calibrate it with one of these sizes");
  return best;
}

double setRate(V4l2Device& device, double frames_per_s) {
  v4l2_streamparm parameters = {};
  parameters.type = kCapture;
  if (device.ask(VIDIOC_G_PARM, &parameters) < 0) return 0.0;
  parameters.parm.capture.timeperframe = {1000, std::uint32_t(std::lround(1000 * frames_per_s))};
  device.ask(VIDIOC_S_PARM, &parameters);
  if (device.ask(VIDIOC_G_PARM, &parameters) < 0) return 0.0;
  return rate(parameters.parm.capture.timeperframe);
}

cv::Mat decodeJpeg(const void* bytes, std::size_t size) {
  const cv::Mat buffer(1, int(size), CV_8U, const_cast<void*>(bytes));
  try {
    return cv::imdecode(buffer, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    return {};
  }
}

/// True if the end marker exists: the decoder fills the missing part of a cut JPEG with grey. Cameras pad
/// behind the end marker with zeros.
bool isWholeJpeg(const void* bytes, std::size_t size) {
  const auto* byte = static_cast<const unsigned char*>(bytes);
  while (size > 2 && byte[size - 1] == 0) --size;
  return size > 4 && byte[0] == 0xFF && byte[1] == 0xD8 && byte[size - 2] == 0xFF && byte[size - 1] == 0xD9;
}

}  // namespace

std::string formatName(std::uint32_t code) {
  if (code == V4L2_PIX_FMT_MJPEG) return "MJPG";
  return code == V4L2_PIX_FMT_GREY ? "GREY" : "YUYV";
}

V4l2Format setFormat(V4l2Device& device, const CameraSettings& settings, const std::string& camera) {
  v4l2_format format = {};
  format.type = kCapture;
  format.fmt.pix.width = std::uint32_t(settings.width_px);
  format.fmt.pix.height = std::uint32_t(settings.height_px);
  format.fmt.pix.pixelformat = chooseFormat(device, settings, camera);
  format.fmt.pix.field = V4L2_FIELD_NONE;
  const std::uint32_t code = format.fmt.pix.pixelformat;
  device.require(VIDIOC_S_FMT, &format, "the camera does not take its picture format");
  const v4l2_pix_format& got = format.fmt.pix;  // the driver writes its actual setting
  if (int(got.width) != settings.width_px || int(got.height) != settings.height_px || got.pixelformat != code)
    throw wrongSize(settings, camera,
                    "it gives " + std::to_string(got.width) + " x " + std::to_string(got.height) +
                        " px instead; calibrate it with that size");
  const int least = int(got.width) * (code == V4L2_PIX_FMT_YUYV ? 2 : 1);
  return {code, int(got.width), int(got.height), std::max(least, int(got.bytesperline)),
          setRate(device, settings.frames_per_s)};
}

cv::Mat decodeGrey(const V4l2Format& format, const void* bytes, std::size_t size) {
  if (format.code == V4L2_PIX_FMT_MJPEG) {
    if (!isWholeJpeg(bytes, size)) return {};
    cv::Mat grey = decodeJpeg(bytes, size);
    return grey.cols == format.width_px && grey.rows == format.height_px ? grey : cv::Mat();
  }
  const bool is_yuyv = format.code == V4L2_PIX_FMT_YUYV;
  const std::size_t row = std::size_t(format.width_px) * (is_yuyv ? 2 : 1);
  if (size < std::size_t(format.bytes_a_row) * std::size_t(format.height_px - 1) + row) return {};
  const cv::Mat raw(format.height_px, format.width_px, is_yuyv ? CV_8UC2 : CV_8UC1, const_cast<void*>(bytes),
                    std::size_t(format.bytes_a_row));
  cv::Mat grey;
  if (is_yuyv)
    cv::extractChannel(raw, grey, 0);
  else
    raw.copyTo(grey);
  return grey;
}

}  // namespace facenav::capture
