#pragma once
// FakeV4l2: a fake Video4Linux kernel. Cameras with modes and controls that deliver pictures in real time,
// and every fault that real ones show. Faults may be set while another thread reads.

#include <linux/videodev2.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <deque>
#include <map>
#include <mutex>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <thread>
#include <vector>

#include "facenav/capture/v4l2_driver.h"
#include "facenav/core/timestamp.h"

namespace facenav::testing {

/// Makes a picture that differs from all others: its first pixels encode its number.
inline cv::Mat numberedPicture(int width, int height, std::int64_t number) {
  cv::Mat image(height, width, CV_8U);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at<std::uint8_t>(y, x) = std::uint8_t(64 + (x + 2 * y + 5 * number) % 128);
  return image;
}

struct FakeV4l2Camera {
  struct Mode {
    std::uint32_t format;
    int width, height;
    double frames_per_s;
  };
  struct Control {
    int minimum, maximum, step, value;
    bool is_stuck = false;          // keeps its value when set
    bool forgets_at_start = false;  // back to `at_start` when the stream starts
    int at_start = 0;
  };
  std::vector<Mode> modes{{V4L2_PIX_FMT_YUYV, 64, 48, 100}, {V4L2_PIX_FMT_MJPEG, 64, 48, 100}};
  std::map<std::uint32_t, Control> controls{
      {V4L2_CID_EXPOSURE_AUTO, {0, 3, 1, V4L2_EXPOSURE_APERTURE_PRIORITY}},
      {V4L2_CID_EXPOSURE_ABSOLUTE, {3, 2047, 1, 156}},
      {V4L2_CID_GAIN, {0, 255, 1, 32}},
      {V4L2_CID_FOCUS_AUTO, {0, 1, 1, 1}},
      {V4L2_CID_FOCUS_ABSOLUTE, {0, 250, 5, 30}},
      {V4L2_CID_AUTO_WHITE_BALANCE, {0, 1, 1, 1}},
      {V4L2_CID_WHITE_BALANCE_TEMPERATURE, {2000, 6500, 1, 4000}}};
  int open_error = 0;                // errno of open()
  std::atomic<bool> is_busy{false};  // another program streams
  std::atomic<bool> is_unplugged{false}, is_hung{false};
  std::atomic<bool> is_bandwidth_short{false};  // uncompressed pictures do not fit
  std::atomic<double> slowdown{1.0};
  std::atomic<int> drop{0}, damage{0}, lose{0}, repeat{0};  // faults of so many next pictures
  std::atomic<double> stamp_shift_s{0.0};                   // error of the time stamps
  std::uint32_t stamp_flags = V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC | V4L2_BUF_FLAG_TSTAMP_SRC_SOE;
  double phase_s = 0.0;          // phase of its exposures within an interval
  int automatic_exposure = 333;  // value found while it runs on automatic
  int forced_width = 0;          // S_FMT returns this width for any request
  std::int64_t pictures = 0;     // taken since the start

  // Driver state.
  Mode current{V4L2_PIX_FMT_YUYV, 64, 48, 100};
  bool is_streaming = false;
  std::deque<std::uint32_t> queued;
  std::vector<std::vector<std::uint8_t>> memory;
  double begun_s = 0.0, last_due_s = 0.0;
  std::int64_t shown = 0;
};

class FakeV4l2 : public capture::V4l2Driver {
 public:
  /// Cameras by path: "/dev/video0". A path without a camera does not exist.
  std::map<std::string, std::shared_ptr<FakeV4l2Camera>> cameras;
  int open_devices = 0, mapped_buffers = 0;

  int open(const std::string& path) override {
    const auto found = cameras.find(path);
    if (found == cameras.end() || found->second->is_unplugged) return -ENOENT;
    if (found->second->open_error) return -found->second->open_error;
    const std::lock_guard lock(mutex_);
    ++open_devices;
    devices_[next_] = found->second;
    return next_++;
  }
  void close(int device) override {
    const std::lock_guard lock(mutex_);
    --open_devices;
    devices_.erase(device);
  }
  void* map(int device, std::size_t, std::size_t offset) override {
    ++mapped_buffers;
    return at(device)->memory.at(offset).data();
  }
  void unmap(void*, std::size_t) override { --mapped_buffers; }
  int wait(int device, int timeout_ms) override {
    const auto camera = at(device);
    const double until_s = Timestamp::now().s + 1e-3 * timeout_ms;
    while (Timestamp::now().s < until_s) {
      if (camera->is_unplugged) return 1;  // as poll does: the error is read by the next call
      const double due_s = dueOfNext(*camera);
      if (!camera->is_hung && Timestamp::now().s >= due_s) return 1;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return 0;
  }
  int control(int device, unsigned long request, void* argument) override {
    const auto camera = at(device);
    if (camera->is_unplugged) return -ENODEV;
    switch (request) {
      case VIDIOC_QUERYCAP: {
        auto* answer = static_cast<v4l2_capability*>(argument);
        answer->capabilities = V4L2_CAP_DEVICE_CAPS;
        answer->device_caps = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
        return 0;
      }
      case VIDIOC_ENUM_FMT:
        return listFormat(*camera, *static_cast<v4l2_fmtdesc*>(argument));
      case VIDIOC_ENUM_FRAMESIZES:
        return listSize(*camera, *static_cast<v4l2_frmsizeenum*>(argument));
      case VIDIOC_ENUM_FRAMEINTERVALS:
        return listInterval(*camera, *static_cast<v4l2_frmivalenum*>(argument));
      case VIDIOC_S_FMT:
        return setFormat(*camera, *static_cast<v4l2_format*>(argument));
      case VIDIOC_G_PARM: {
        static_cast<v4l2_streamparm*>(argument)->parm.capture.timeperframe = {
            1000, std::uint32_t(1000 * camera->current.frames_per_s)};
        return 0;
      }
      case VIDIOC_S_PARM:
        return 0;  // for a camera with one rate a mode
      case VIDIOC_QUERYCTRL:
        return queryControl(*camera, *static_cast<v4l2_queryctrl*>(argument));
      case VIDIOC_G_CTRL:
        return getControl(*camera, *static_cast<v4l2_control*>(argument));
      case VIDIOC_S_CTRL:
        return setControl(*camera, *static_cast<v4l2_control*>(argument));
      case VIDIOC_REQBUFS:
        return requestBuffers(*camera, *static_cast<v4l2_requestbuffers*>(argument));
      case VIDIOC_QUERYBUF: {
        auto* buffer = static_cast<v4l2_buffer*>(argument);
        buffer->length = std::uint32_t(camera->memory.at(buffer->index).size());
        buffer->m.offset = buffer->index;
        return 0;
      }
      case VIDIOC_QBUF:
        camera->queued.push_back(static_cast<v4l2_buffer*>(argument)->index);
        return 0;
      case VIDIOC_STREAMON:
        return startStream(*camera);
      case VIDIOC_STREAMOFF:
        camera->is_streaming = false;
        return 0;
      case VIDIOC_DQBUF:
        return fill(*camera, *static_cast<v4l2_buffer*>(argument));
      default:
        return -ENOTTY;
    }
  }

 private:
  std::shared_ptr<FakeV4l2Camera> at(int device) {
    const std::lock_guard lock(mutex_);
    return devices_.at(device);
  }
  static double interval(const FakeV4l2Camera& camera) {
    return camera.slowdown / camera.current.frames_per_s;
  }
  static double dueOfNext(const FakeV4l2Camera& camera) { return camera.last_due_s + interval(camera); }

  static std::vector<std::uint32_t> formats(const FakeV4l2Camera& camera) {
    std::vector<std::uint32_t> all;
    for (const auto& mode : camera.modes)
      if (all.empty() || all.back() != mode.format) all.push_back(mode.format);
    return all;
  }
  static std::vector<FakeV4l2Camera::Mode> modesOf(const FakeV4l2Camera& camera, std::uint32_t format) {
    std::vector<FakeV4l2Camera::Mode> all;
    for (const auto& mode : camera.modes)
      if (mode.format == format) all.push_back(mode);
    return all;
  }
  static int listFormat(const FakeV4l2Camera& camera, v4l2_fmtdesc& entry) {
    const auto all = formats(camera);
    if (entry.index >= all.size()) return -EINVAL;
    entry.pixelformat = all[entry.index];
    return 0;
  }
  static int listSize(const FakeV4l2Camera& camera, v4l2_frmsizeenum& entry) {
    const auto all = modesOf(camera, entry.pixel_format);
    if (entry.index >= all.size()) return -EINVAL;
    entry.type = V4L2_FRMSIZE_TYPE_DISCRETE;
    entry.discrete = {std::uint32_t(all[entry.index].width), std::uint32_t(all[entry.index].height)};
    return 0;
  }
  static int listInterval(const FakeV4l2Camera& camera, v4l2_frmivalenum& entry) {
    for (const auto& mode : modesOf(camera, entry.pixel_format)) {
      if (std::uint32_t(mode.width) != entry.width || std::uint32_t(mode.height) != entry.height ||
          entry.index > 0)
        continue;
      entry.type = V4L2_FRMIVAL_TYPE_DISCRETE;
      entry.discrete = {1000, std::uint32_t(1000 * mode.frames_per_s)};
      return 0;
    }
    return -EINVAL;
  }
  static int setFormat(FakeV4l2Camera& camera, v4l2_format& format) {
    if (camera.is_busy) return -EBUSY;
    auto all = modesOf(camera, format.fmt.pix.pixelformat);
    if (all.empty()) all = camera.modes;
    camera.current = all.front();
    for (const auto& mode : all)
      if (std::uint32_t(mode.width) == format.fmt.pix.width &&
          std::uint32_t(mode.height) == format.fmt.pix.height)
        camera.current = mode;
    if (camera.forced_width) camera.current.width = camera.forced_width;
    format.fmt.pix.width = std::uint32_t(camera.current.width);
    format.fmt.pix.height = std::uint32_t(camera.current.height);
    format.fmt.pix.pixelformat = camera.current.format;
    format.fmt.pix.bytesperline = bytesPerLine(camera);
    return 0;
  }
  /// Bytes of a line, padded as some drivers do.
  static std::uint32_t bytesPerLine(const FakeV4l2Camera& camera) {
    if (camera.current.format == V4L2_PIX_FMT_MJPEG) return 0;
    return std::uint32_t(camera.current.width * (camera.current.format == V4L2_PIX_FMT_YUYV ? 2 : 1) + 16);
  }
  static int queryControl(const FakeV4l2Camera& camera, v4l2_queryctrl& query) {
    const auto found = camera.controls.find(query.id);
    if (found == camera.controls.end()) return -EINVAL;
    query.minimum = found->second.minimum;
    query.maximum = found->second.maximum;
    query.step = found->second.step;
    return 0;
  }
  static int getControl(const FakeV4l2Camera& camera, v4l2_control& control) {
    const auto found = camera.controls.find(control.id);
    if (found == camera.controls.end()) return -EINVAL;
    control.value = found->second.value;
    return 0;
  }
  static int setControl(FakeV4l2Camera& camera, v4l2_control& control) {
    const auto found = camera.controls.find(control.id);
    if (found == camera.controls.end()) return -EINVAL;
    if (control.value < found->second.minimum || control.value > found->second.maximum) return -ERANGE;
    if (!found->second.is_stuck) found->second.value = control.value;
    return 0;
  }
  static int requestBuffers(FakeV4l2Camera& camera, v4l2_requestbuffers& request) {
    if (camera.is_busy) return -EBUSY;
    camera.queued.clear();
    camera.memory.assign(
        request.count,
        std::vector<std::uint8_t>(std::size_t(camera.current.width * camera.current.height * 3 + 4096)));
    return 0;
  }
  static int startStream(FakeV4l2Camera& camera) {
    if (camera.is_busy) return -EBUSY;
    if (camera.is_bandwidth_short && camera.current.format != V4L2_PIX_FMT_MJPEG) return -ENOSPC;
    for (auto& [id, control] : camera.controls)
      if (control.forgets_at_start) control.value = control.at_start;
    const auto exposure = camera.controls.find(V4L2_CID_EXPOSURE_ABSOLUTE);
    if (exposure != camera.controls.end() &&
        camera.controls[V4L2_CID_EXPOSURE_AUTO].value != V4L2_EXPOSURE_MANUAL)
      exposure->second.value = camera.automatic_exposure;
    camera.is_streaming = true;
    const double interval_s = interval(camera), now_s = Timestamp::now().s;
    camera.begun_s = camera.last_due_s = std::floor(now_s / interval_s) * interval_s + camera.phase_s;
    camera.pictures = 0;
    return 0;
  }
  static int fill(FakeV4l2Camera& camera, v4l2_buffer& buffer) {
    if (!camera.is_streaming) return -EINVAL;
    if (camera.queued.empty() || camera.is_hung || Timestamp::now().s < dueOfNext(camera)) return -EAGAIN;
    for (int dropped = camera.drop.exchange(0) + 1; dropped > 0; --dropped) {
      camera.last_due_s = dueOfNext(camera);
      ++camera.pictures;
    }
    while (Timestamp::now().s < camera.last_due_s) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (camera.lose > 0) return --camera.lose, -EIO;
    buffer.index = camera.queued.front();
    camera.queued.pop_front();
    if (camera.repeat > 0)
      --camera.repeat;
    else
      camera.shown = camera.pictures;
    buffer.bytesused = write(camera, camera.memory.at(buffer.index));
    buffer.sequence = std::uint32_t(camera.pictures);
    buffer.flags = camera.stamp_flags;
    if (camera.damage > 0) {
      --camera.damage;
      buffer.bytesused /= 2;
    }
    const double stamp_s = camera.last_due_s + camera.stamp_shift_s;
    buffer.timestamp.tv_sec = long(std::floor(stamp_s));
    buffer.timestamp.tv_usec = long(1e6 * (stamp_s - std::floor(stamp_s)));
    return 0;
  }
  static std::uint32_t write(const FakeV4l2Camera& camera, std::vector<std::uint8_t>& memory) {
    const cv::Mat image = numberedPicture(camera.current.width, camera.current.height, camera.shown);
    if (camera.current.format == V4L2_PIX_FMT_MJPEG) {
      std::vector<std::uint8_t> jpeg;
      cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, 95});
      std::copy(jpeg.begin(), jpeg.end(), memory.begin());
      return std::uint32_t(jpeg.size());
    }
    const bool is_yuyv = camera.current.format == V4L2_PIX_FMT_YUYV;
    const std::size_t line = bytesPerLine(camera);
    for (int y = 0; y < image.rows; ++y)
      for (int x = 0; x < image.cols; ++x) {
        const std::size_t byte = std::size_t(y) * line + std::size_t(is_yuyv ? 2 * x : x);
        memory[byte] = image.at<std::uint8_t>(y, x);
        if (is_yuyv) memory[byte + 1] = 128;
      }
    return std::uint32_t(line * std::size_t(image.rows));
  }

  std::mutex mutex_;
  std::map<int, std::shared_ptr<FakeV4l2Camera>> devices_;
  int next_ = 3;
};

}  // namespace facenav::testing
