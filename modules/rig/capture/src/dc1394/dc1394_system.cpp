// Dc1394Driver that calls libdc1394.

#include <dc1394/dc1394.h>
#include <poll.h>

#include "facenav/capture/dc1394_driver.h"

namespace facenav::capture {
namespace {

constexpr std::uint32_t kDmaBuffers = 4;

Dc1394Answer answerOf(dc1394error_t error) {
  switch (error) {
    case DC1394_SUCCESS:
      return Dc1394Answer::done;
    case DC1394_NO_BANDWIDTH:
    case DC1394_NO_ISO_CHANNEL:
      return Dc1394Answer::no_bandwidth;
    case DC1394_CAPTURE_IS_RUNNING:
      return Dc1394Answer::busy;
    case DC1394_RAW1394_FAILURE:
    case DC1394_IOCTL_FAILURE:
      return Dc1394Answer::gone;
    default:
      return Dc1394Answer::refused;
  }
}

dc1394feature_t idOf(Dc1394Feature feature) {
  switch (feature) {
    case Dc1394Feature::shutter:
      return DC1394_FEATURE_SHUTTER;
    case Dc1394Feature::gain:
      return DC1394_FEATURE_GAIN;
    case Dc1394Feature::focus:
      return DC1394_FEATURE_FOCUS;
  }
  return DC1394_FEATURE_SHUTTER;
}

class SystemDc1394Device : public Dc1394Device {
 public:
  SystemDc1394Device(std::shared_ptr<dc1394_t> bus, dc1394camera_t* camera)
      : bus_(std::move(bus)), camera_(camera) {}
  ~SystemDc1394Device() override {
    SystemDc1394Device::stop();
    dc1394_camera_free(camera_);
  }
  std::vector<Dc1394Mode> modes() override;
  Dc1394Answer setMode(const Dc1394Mode& mode, double rate) override;
  std::optional<Dc1394Adjustment> read(Dc1394Feature feature) override;
  void write(Dc1394Feature feature, bool is_automatic, std::optional<double> value) override;
  Dc1394Answer setTrigger(Trigger trigger) override;
  Dc1394Answer pullTrigger() override {
    return answerOf(dc1394_software_trigger_set_power(camera_, DC1394_ON));
  }
  Dc1394Answer start() override;
  void stop() override;
  std::optional<Dc1394Picture> take(double timeout_s, bool& is_gone) override;
  void giveBack() override {
    if (frame_) dc1394_capture_enqueue(camera_, frame_);
    frame_ = nullptr;
  }

 private:
  std::shared_ptr<dc1394_t> bus_;
  dc1394camera_t* camera_;
  dc1394video_frame_t* frame_ = nullptr;
  bool is_running_ = false;
};

std::vector<Dc1394Mode> SystemDc1394Device::modes() {
  std::vector<Dc1394Mode> all;
  dc1394video_modes_t listed;
  if (dc1394_video_get_supported_modes(camera_, &listed) != DC1394_SUCCESS) return all;
  for (std::uint32_t i = 0; i < listed.num; ++i) {
    if (dc1394_is_video_mode_scalable(listed.modes[i])) continue;
    dc1394color_coding_t coding;
    std::uint32_t width = 0, height = 0;
    dc1394framerates_t rates;
    if (dc1394_get_color_coding_from_video_mode(camera_, listed.modes[i], &coding) != DC1394_SUCCESS ||
        (coding != DC1394_COLOR_CODING_MONO8 && coding != DC1394_COLOR_CODING_YUV422) ||
        dc1394_get_image_size_from_video_mode(camera_, listed.modes[i], &width, &height) != DC1394_SUCCESS ||
        dc1394_video_get_supported_framerates(camera_, listed.modes[i], &rates) != DC1394_SUCCESS)
      continue;
    Dc1394Mode mode{int(listed.modes[i]), int(width), int(height), coding == DC1394_COLOR_CODING_YUV422, {}};
    for (std::uint32_t k = 0; k < rates.num; ++k) {
      float rate = 0;
      if (dc1394_framerate_as_float(rates.framerates[k], &rate) == DC1394_SUCCESS) mode.rates.push_back(rate);
    }
    all.push_back(mode);
  }
  return all;
}

Dc1394Answer SystemDc1394Device::setMode(const Dc1394Mode& mode, double rate) {
  const auto id = dc1394video_mode_t(mode.id);
  if (const auto error = dc1394_video_set_mode(camera_, id); error != DC1394_SUCCESS) return answerOf(error);
  dc1394framerates_t rates;
  if (const auto error = dc1394_video_get_supported_framerates(camera_, id, &rates); error != DC1394_SUCCESS)
    return answerOf(error);
  for (std::uint32_t k = 0; k < rates.num; ++k) {
    float each = 0;
    dc1394_framerate_as_float(rates.framerates[k], &each);
    if (each == float(rate)) return answerOf(dc1394_video_set_framerate(camera_, rates.framerates[k]));
  }
  return Dc1394Answer::refused;
}

std::optional<Dc1394Adjustment> SystemDc1394Device::read(Dc1394Feature feature) {
  const auto id = idOf(feature);
  dc1394bool_t is_there = DC1394_FALSE, has_unit = DC1394_FALSE;
  if (dc1394_feature_is_present(camera_, id, &is_there) != DC1394_SUCCESS || !is_there) return std::nullopt;
  Dc1394Adjustment adjustment;
  dc1394feature_mode_t mode = DC1394_FEATURE_MODE_MANUAL;
  if (dc1394_feature_get_mode(camera_, id, &mode) == DC1394_SUCCESS)
    adjustment.is_automatic = mode == DC1394_FEATURE_MODE_AUTO;
  dc1394_feature_has_absolute_control(camera_, id, &has_unit);
  adjustment.has_unit = has_unit == DC1394_TRUE;
  if (adjustment.has_unit) {
    float low = 0, high = 0, value = 0;
    dc1394_feature_get_absolute_boundaries(camera_, id, &low, &high);
    dc1394_feature_get_absolute_value(camera_, id, &value);
    adjustment.minimum = low, adjustment.maximum = high, adjustment.value = value;
  } else {
    std::uint32_t low = 0, high = 0, value = 0;
    dc1394_feature_get_boundaries(camera_, id, &low, &high);
    dc1394_feature_get_value(camera_, id, &value);
    adjustment.minimum = low, adjustment.maximum = high, adjustment.value = value;
  }
  return adjustment;
}

void SystemDc1394Device::write(Dc1394Feature feature, bool is_automatic, std::optional<double> value) {
  const auto id = idOf(feature);
  const auto adjustment = read(feature);
  if (!adjustment) return;
  dc1394_feature_set_mode(camera_, id, is_automatic ? DC1394_FEATURE_MODE_AUTO : DC1394_FEATURE_MODE_MANUAL);
  if (is_automatic || !value) return;
  if (adjustment->has_unit) {
    dc1394_feature_set_absolute_control(camera_, id, DC1394_ON);
    dc1394_feature_set_absolute_value(camera_, id, float(*value));
  } else {
    dc1394_feature_set_value(camera_, id, std::uint32_t(*value + 0.5));
  }
}

Dc1394Answer SystemDc1394Device::setTrigger(Trigger trigger) {
  const auto error =
      dc1394_external_trigger_set_power(camera_, trigger == Trigger::free_run ? DC1394_OFF : DC1394_ON);
  if (trigger == Trigger::free_run)
    return Dc1394Answer::done;  // a camera without a trigger refuses "off" too
  if (error != DC1394_SUCCESS) return answerOf(error);
  if (trigger == Trigger::software)
    return answerOf(dc1394_external_trigger_set_source(camera_, DC1394_TRIGGER_SOURCE_SOFTWARE));
  return answerOf(dc1394_external_trigger_set_mode(camera_, DC1394_TRIGGER_MODE_0));
}

Dc1394Answer SystemDc1394Device::start() {
  if (const auto error = dc1394_capture_setup(camera_, kDmaBuffers, DC1394_CAPTURE_FLAGS_DEFAULT);
      error != DC1394_SUCCESS)
    return answerOf(error);
  is_running_ = true;
  const auto error = dc1394_video_set_transmission(camera_, DC1394_ON);
  if (error != DC1394_SUCCESS) stop();
  return answerOf(error);
}

void SystemDc1394Device::stop() {
  if (!is_running_) return;
  giveBack();
  dc1394_video_set_transmission(camera_, DC1394_OFF);
  dc1394_capture_stop(camera_);
  is_running_ = false;
}

std::optional<Dc1394Picture> SystemDc1394Device::take(double timeout_s, bool& is_gone) {
  pollfd ready{dc1394_capture_get_fileno(camera_), POLLIN, 0};
  const int count = ::poll(&ready, 1, int(1e3 * timeout_s) + 1);
  if (count > 0 && (ready.revents & (POLLERR | POLLHUP | POLLNVAL))) is_gone = true;
  if (count <= 0 || is_gone) return std::nullopt;
  const auto error = dc1394_capture_dequeue(camera_, DC1394_CAPTURE_POLICY_POLL, &frame_);
  is_gone = answerOf(error) == Dc1394Answer::gone;
  if (error != DC1394_SUCCESS || !frame_) return std::nullopt;
  return Dc1394Picture{frame_->image, frame_->stride, 1e-6 * double(frame_->timestamp),
                       dc1394_capture_is_frame_corrupt(camera_, frame_) == DC1394_TRUE};
}

class SystemDc1394Driver : public Dc1394Driver {
 public:
  std::vector<Dc1394Unit> list() override;
  std::unique_ptr<Dc1394Device> open(std::uint64_t guid) override {
    const auto bus = openBus();
    auto* camera = bus ? dc1394_camera_new(bus.get(), guid) : nullptr;
    return camera ? std::make_unique<SystemDc1394Device>(bus, camera) : nullptr;
  }

 private:
  /// Opens the bus; null if this computer has none.
  static std::shared_ptr<dc1394_t> openBus() {
    for (const auto kind : {DC1394_LOG_ERROR, DC1394_LOG_WARNING, DC1394_LOG_DEBUG})
      dc1394_log_register_handler(kind, nullptr, nullptr);  // this program reports errors itself
    auto* bus = dc1394_new();
    return bus ? std::shared_ptr<dc1394_t>(bus, dc1394_free) : nullptr;
  }
};

std::vector<Dc1394Unit> SystemDc1394Driver::list() {
  std::vector<Dc1394Unit> units;
  const auto bus = openBus();
  dc1394camera_list_t* listed = nullptr;
  if (!bus || dc1394_camera_enumerate(bus.get(), &listed) != DC1394_SUCCESS) return units;
  for (std::uint32_t i = 0; i < listed->num; ++i) {
    auto* camera = dc1394_camera_new(bus.get(), listed->ids[i].guid);
    if (!camera) continue;
    units.push_back({camera->guid, camera->vendor ? camera->vendor : "", camera->model ? camera->model : ""});
    dc1394_camera_free(camera);
  }
  dc1394_camera_free_list(listed);
  return units;
}

}  // namespace

std::unique_ptr<CameraBackend> makeDc1394Backend() {
  return makeDc1394Backend(std::make_shared<SystemDc1394Driver>());
}

}  // namespace facenav::capture
