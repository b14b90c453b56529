#include "v4l2_camera.h"

#include <linux/videodev2.h>

#include "picture_intake.h"
#include "v4l2_controls.h"
#include "v4l2_format.h"
#include "v4l2_stream.h"

namespace facenav::capture {
namespace {

StampClock clockOf(const V4l2Buffer& buffer) {
  if (buffer.stamp_s <= 0) return StampClock::none;
  const bool is_monotonic =
      (buffer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) == V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC;
  return is_monotonic ? StampClock::steady : StampClock::device;
}

std::string clockInWords(StampClock clock, std::uint32_t flags) {
  if (clock == StampClock::none) return "time of arrival; the driver gives no time stamps";
  if (clock == StampClock::device) return "the driver's time stamps, fitted to this computer's clock";
  return (flags & V4L2_BUF_FLAG_TSTAMP_SRC_MASK) == V4L2_BUF_FLAG_TSTAMP_SRC_SOE
             ? "the driver's time stamps, at the start of exposure"
             : "the driver's time stamps, at the end of the picture";
}

class V4l2Camera : public Camera {
 public:
  V4l2Camera(std::shared_ptr<V4l2Driver> driver, const CameraIdentity& identity)
      : identity_(identity), device_(std::move(driver), identity) {}
  const CameraIdentity& identity() const override { return identity_; }
  CameraState configure(const CameraSettings& settings) override;
  void start() override;
  CameraState state() const override { return state_; }
  std::optional<CameraPicture> next(double timeout_s) override;
  void trigger() override;
  void stop() override { stream_.reset(); }
  PictureCounts counts() const override { return intake_.counts(); }

 private:
  void applyFormat(const CameraSettings& settings);
  void noteRate();
  void startWithLessBandwidth(const CameraError& refusal);
  std::optional<CameraPicture> read(const V4l2Buffer& buffer, double arrival_s);

  CameraIdentity identity_;
  V4l2Device device_;
  CameraSettings settings_;
  CameraState state_;
  V4l2Format format_;
  std::unique_ptr<V4l2Stream> stream_;  // while it runs; released before the device
  PictureIntake intake_;
};

void V4l2Camera::applyFormat(const CameraSettings& settings) {
  format_ = setFormat(device_, settings, inWords(identity_));
  state_.width_px = format_.width_px;
  state_.height_px = format_.height_px;
  state_.frames_per_s = format_.frames_per_s;
  state_.format = formatName(format_.code);
}

void V4l2Camera::noteRate() {
  if (state_.frames_per_s > 0 && state_.frames_per_s < 0.95 * settings_.frames_per_s)
    state_.notes.push_back("the camera gives " + std::to_string(int(std::lround(state_.frames_per_s))) +
                           " pictures a second in this size, " +
                           std::to_string(int(std::lround(settings_.frames_per_s))) + " were asked for");
}

CameraState V4l2Camera::configure(const CameraSettings& settings) {
  stop();
  if (settings.trigger != Trigger::free_run)
    throw CameraError(CameraFault::refused, "Video4Linux has no trigger", inWords(identity_),
                      "let the cameras run free");
  settings_ = settings;
  state_ = {};
  applyFormat(settings);
  noteRate();
  if (settings.is_adjusting)
    freeControls(device_);
  else
    state_.controls = lockControls(device_, settings);
  return state_;
}

/// Starts with compressed pictures, which need a tenth of the bandwidth: two cameras may share one USB
/// controller.
void V4l2Camera::startWithLessBandwidth(const CameraError& refusal) {
  if (refusal.fault() != CameraFault::no_bandwidth || !settings_.format.empty() || state_.format == "MJPG")
    throw refusal;
  CameraSettings compressed = settings_;
  compressed.format = "MJPG";
  try {
    applyFormat(compressed);
  } catch (const CameraError&) {
    throw refusal;
  }
  stream_ = std::make_unique<V4l2Stream>(device_);
  state_.notes.push_back("compressed pictures (MJPG): the USB connection cannot carry others");
}

void V4l2Camera::start() {
  stop();
  intake_.restart();
  try {
    stream_ = std::make_unique<V4l2Stream>(device_);
  } catch (const CameraError& refusal) {
    startWithLessBandwidth(refusal);
  }
  confirmControls(device_, state_.controls);
}

std::optional<CameraPicture> V4l2Camera::read(const V4l2Buffer& buffer, double arrival_s) {
  cv::Mat grey;
  if (!(buffer.flags & V4L2_BUF_FLAG_ERROR)) grey = decodeGrey(format_, buffer.bytes, buffer.size);
  if (grey.empty()) {
    intake_.noteDamaged();
    return std::nullopt;
  }
  const StampClock clock = clockOf(buffer);
  if (state_.clock.empty()) state_.clock = clockInWords(clock, buffer.flags);
  return intake_.accept(std::move(grey), buffer.sequence, clock, buffer.stamp_s, arrival_s);
}

std::optional<CameraPicture> V4l2Camera::next(double timeout_s) {
  FACENAV_EXPECT(stream_, "start() first");
  const double until_s = Timestamp::now().s + timeout_s;
  for (double left_s = timeout_s; left_s > 0; left_s = until_s - Timestamp::now().s) {
    const auto buffer = stream_->take(left_s);
    if (!buffer) continue;
    auto picture = read(*buffer, Timestamp::now().s);
    stream_->giveBack(*buffer);
    if (picture) return picture;
  }
  return std::nullopt;
}

void V4l2Camera::trigger() {
  throw CameraError(CameraFault::refused, "Video4Linux has no trigger", inWords(identity_),
                    "let the cameras run free");
}

}  // namespace

std::unique_ptr<Camera> openV4l2Camera(std::shared_ptr<V4l2Driver> driver, const CameraIdentity& camera) {
  return std::make_unique<V4l2Camera>(std::move(driver), camera);
}

}  // namespace facenav::capture
