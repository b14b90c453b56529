// IEEE 1394 cameras (IIDC): the fixed video modes in grey and YUV 4:2:2. Format 7 is not used.

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "facenav/capture/dc1394_driver.h"
#include "facenav/core/number_text.h"
#include "picture_intake.h"

namespace facenav::capture {
namespace {

struct Dc1394Control {
  Dc1394Feature feature;
  const char* name;
  const char* unit;  // unit, if the camera has one
  double per_unit;   // displayed value of one of the camera's units
  std::optional<double> CameraSettings::*wanted;
};
const Dc1394Control kDc1394Controls[] = {
    {Dc1394Feature::shutter, "exposure", "ms", 1e3, &CameraSettings::exposure_ms},
    {Dc1394Feature::gain, "gain", "dB", 1.0, &CameraSettings::gain},
    {Dc1394Feature::focus, "focus", "", 1.0, &CameraSettings::focus}};

std::string asGuid(std::uint64_t guid) { return formatted("%016llx", static_cast<unsigned long long>(guid)); }

class Dc1394Camera : public Camera {
 public:
  Dc1394Camera(CameraIdentity identity, std::unique_ptr<Dc1394Device> device)
      : identity_(std::move(identity)), device_(std::move(device)) {}
  ~Dc1394Camera() override { stop(); }
  const CameraIdentity& identity() const override { return identity_; }
  CameraState configure(const CameraSettings& settings) override;
  void start() override;
  CameraState state() const override { return state_; }
  std::optional<CameraPicture> next(double timeout_s) override;
  void trigger() override { require(device_->pullTrigger(), "the camera takes no software trigger"); }
  void stop() override;
  PictureCounts counts() const override { return intake_.counts(); }

 private:
  void require(Dc1394Answer answer, const std::string& refusal) const;
  Dc1394Mode modeFor(const CameraSettings& settings) const;
  [[noreturn]] void refuseSize(const CameraSettings& settings, const std::vector<Dc1394Mode>& modes) const;
  void chooseRate(const CameraSettings& settings);
  ControlState lock(const Dc1394Control& control, const CameraSettings& settings);
  void confirm();
  std::optional<CameraPicture> read(const Dc1394Picture& picture);

  CameraIdentity identity_;
  std::unique_ptr<Dc1394Device> device_;
  CameraSettings settings_;
  CameraState state_;
  Dc1394Mode mode_;
  PictureIntake intake_;
  std::int64_t sequence_ = 0;
  bool is_running_ = false;
};

void Dc1394Camera::require(Dc1394Answer answer, const std::string& refusal) const {
  switch (answer) {
    case Dc1394Answer::done:
      return;
    case Dc1394Answer::busy:
      throw CameraError(CameraFault::in_use, "the camera is in use by another program", inWords(identity_),
                        "close that program");
    case Dc1394Answer::no_bandwidth:
      throw CameraError(CameraFault::no_bandwidth, "the IEEE 1394 bus cannot carry its pictures",
                        inWords(identity_), "use a lower rate, or a bus for each camera");
    case Dc1394Answer::gone:
      throw CameraError(CameraFault::unplugged, "the camera was unplugged", inWords(identity_),
                        "plug it in and open the cameras again");
    case Dc1394Answer::refused:
      throw CameraError(CameraFault::refused, refusal, inWords(identity_), "try other settings");
  }
}

void Dc1394Camera::refuseSize(const CameraSettings& settings, const std::vector<Dc1394Mode>& modes) const {
  std::string sizes;
  for (const auto& mode : modes) {
    const std::string size = formatted("%d x %d", mode.width_px, mode.height_px);
    if (sizes.find(size) == std::string::npos) sizes += (sizes.empty() ? "" : ", ") + size;
  }
  throw CameraError(
      CameraFault::wrong_size,
      formatted("the camera gives no pictures of %d x %d px", settings.width_px, settings.height_px),
      inWords(identity_), "it has " + (sizes.empty() ? "none in grey or YUV 4:2:2" : sizes));
}

/// Chooses the mode; grey before YUV: half the bandwidth.
Dc1394Mode Dc1394Camera::modeFor(const CameraSettings& settings) const {
  const auto modes = device_->modes();
  const Dc1394Mode* best = nullptr;
  for (const auto& mode : modes) {
    if (mode.width_px != settings.width_px || mode.height_px != settings.height_px || mode.rates.empty() ||
        (settings.format == "GREY" && mode.is_yuv422) || (settings.format == "UYVY" && !mode.is_yuv422))
      continue;
    if (!best || (best->is_yuv422 && !mode.is_yuv422)) best = &mode;
  }
  if (!best) refuseSize(settings, modes);
  return *best;
}

void Dc1394Camera::chooseRate(const CameraSettings& settings) {
  const double rate = *std::min_element(mode_.rates.begin(), mode_.rates.end(), [&](double a, double b) {
    return std::abs(std::log(a / settings.frames_per_s)) < std::abs(std::log(b / settings.frames_per_s));
  });
  require(device_->setMode(mode_, rate), "the camera refuses this size");
  state_.frames_per_s = rate;
  if (rate < 0.95 * settings.frames_per_s)
    state_.notes.push_back(
        formatted("the camera gives %.4g pictures a second in this size, %.4g were asked for", rate,
                  settings.frames_per_s));
}

ControlState Dc1394Camera::lock(const Dc1394Control& control, const CameraSettings& settings) {
  ControlState state;
  state.name = control.name;
  state.wanted = settings.*control.wanted;
  const auto before = device_->read(control.feature);
  if (!before) return state;
  state.unit = before->has_unit ? control.unit : "";
  const double scale = before->has_unit ? control.per_unit : 1.0;
  state.found = before->value * scale;
  std::optional<double> value;
  if (state.wanted) value = std::clamp(*state.wanted / scale, before->minimum, before->maximum);
  device_->write(control.feature, false, value);
  const auto after = device_->read(control.feature);
  state.lock = ControlState::Lock::refused;
  if (!after) return state;
  state.actual = after->value * scale;
  const double wanted = value.value_or(after->value),
               step = std::max(1e-9, 0.02 * std::abs(wanted) + (before->has_unit ? 0.0 : 0.5));
  if (after->is_automatic)
    state.words = "the camera stays on automatic";
  else if (std::abs(after->value - wanted) > step)
    state.words = formatted("%g %s was asked for, the camera keeps %g", *state.wanted, state.unit.c_str(),
                            *state.actual);
  else
    state.lock = ControlState::Lock::locked;
  return state;
}

CameraState Dc1394Camera::configure(const CameraSettings& settings) {
  stop();
  settings_ = settings;
  state_ = {};
  mode_ = modeFor(settings);
  chooseRate(settings);
  require(device_->setTrigger(settings.trigger), "the camera has no such trigger");
  state_.width_px = mode_.width_px;
  state_.height_px = mode_.height_px;
  state_.format = mode_.is_yuv422 ? "UYVY" : "GREY";
  state_.clock = "the driver's time stamps, when the picture came over the bus";
  for (const auto& control : kDc1394Controls) {
    if (settings.is_adjusting)
      device_->write(control.feature, true, std::nullopt);
    else
      state_.controls.push_back(lock(control, settings));
  }
  return state_;
}

/// Locks again what changed since it was locked.
void Dc1394Camera::confirm() {
  for (std::size_t i = 0; i < state_.controls.size(); ++i)
    if (state_.controls[i].lock == ControlState::Lock::locked) {
      CameraSettings kept = settings_;
      kept.*kDc1394Controls[i].wanted = state_.controls[i].actual;
      const auto found = state_.controls[i].found;  // before the first setting
      state_.controls[i] = lock(kDc1394Controls[i], kept);
      state_.controls[i].found = found;
    }
}

void Dc1394Camera::start() {
  stop();
  intake_.restart();
  require(device_->start(), "the camera refuses to start");
  is_running_ = true;
  confirm();
}

void Dc1394Camera::stop() {
  if (is_running_) device_->stop();
  is_running_ = false;
}

std::optional<CameraPicture> Dc1394Camera::read(const Dc1394Picture& picture) {
  const double arrival_s = Timestamp::now().s;
  const std::chrono::duration<double> unix_now = std::chrono::system_clock::now().time_since_epoch();
  if (picture.is_damaged) {
    intake_.noteDamaged();
    return std::nullopt;
  }
  cv::Mat grey(mode_.height_px, mode_.width_px, CV_8U);
  for (int y = 0; y < grey.rows; ++y) {
    const std::uint8_t* line = picture.bytes + std::size_t(y) * picture.stride;
    for (int x = 0; x < grey.cols; ++x)
      grey.at<std::uint8_t>(y, x) = mode_.is_yuv422 ? line[2 * x + 1] : line[x];
  }
  const double age_s = std::max(0.0, unix_now.count() - picture.unix_s);
  return intake_.accept(std::move(grey), sequence_++, StampClock::steady, arrival_s - age_s, arrival_s);
}

std::optional<CameraPicture> Dc1394Camera::next(double timeout_s) {
  FACENAV_EXPECT(is_running_, "start() first");
  const double until_s = Timestamp::now().s + timeout_s;
  for (double left_s = timeout_s; left_s > 0; left_s = until_s - Timestamp::now().s) {
    bool is_gone = false;
    const auto taken = device_->take(left_s, is_gone);
    if (is_gone) require(Dc1394Answer::gone, {});
    if (!taken) continue;
    auto picture = read(*taken);
    device_->giveBack();
    if (picture) return picture;
  }
  return std::nullopt;
}

class Dc1394Backend : public CameraBackend {
 public:
  explicit Dc1394Backend(std::shared_ptr<Dc1394Driver> driver) : driver_(std::move(driver)) {}
  std::vector<FoundCamera> list() override {
    std::vector<FoundCamera> found;
    for (const auto& unit : driver_->list()) {
      FoundCamera camera;
      camera.identity = {"dc1394", asGuid(unit.guid), unit.vendor + " " + unit.model, asGuid(unit.guid), ""};
      found.push_back(camera);
    }
    return found;
  }
  std::unique_ptr<Camera> open(const CameraIdentity& camera) override {
    auto device = driver_->open(std::strtoull(camera.address.c_str(), nullptr, 16));
    if (!device)
      throw CameraError(CameraFault::missing, "the camera is not on the IEEE 1394 bus", inWords(camera),
                        "plug it in; 'facenav cameras' lists what is there");
    return std::make_unique<Dc1394Camera>(camera, std::move(device));
  }

 private:
  std::shared_ptr<Dc1394Driver> driver_;
};

}  // namespace

std::unique_ptr<CameraBackend> makeDc1394Backend(std::shared_ptr<Dc1394Driver> driver) {
  return std::make_unique<Dc1394Backend>(std::move(driver));
}

}  // namespace facenav::capture
