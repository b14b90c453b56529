#include "genicam_camera.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "facenav/core/number_text.h"
#include "genicam_call.h"
#include "genicam_controls.h"
#include "genicam_picture.h"
#include "picture_intake.h"

namespace facenav::capture {
namespace {

constexpr int kGenicamBuffers = 8;
constexpr double kLatestArrival_s = 1.0;

void onControlLost(ArvDevice*, std::atomic<bool>* is_lost) { *is_lost = true; }

/// Arrival of the buffer's first packet, on the steady clock. Aravis records it on the computer's calendar
/// clock.
double arrivalOf(ArvBuffer* buffer) {
  const double waited_s =
      1e-6 * double(g_get_real_time()) - 1e-9 * double(arv_buffer_get_system_timestamp(buffer));
  return Timestamp::now().s - std::clamp(waited_s, 0.0, kLatestArrival_s);
}

class GenicamCamera : public Camera {
 public:
  explicit GenicamCamera(const CameraIdentity& identity);
  ~GenicamCamera() override;
  const CameraIdentity& identity() const override { return identity_; }
  CameraState configure(const CameraSettings& settings) override;
  void start() override;
  CameraState state() const override { return state_; }
  std::optional<CameraPicture> next(double timeout_s) override;
  void trigger() override;
  void stop() override;
  PictureCounts counts() const override { return intake_.counts(); }

 private:
  CameraError wrongSize(const CameraSettings& settings, const std::string& remedy) const;
  void setRegion(const CameraSettings& settings);
  void setRate(const CameraSettings& settings);
  void prepareNetwork();
  void addBuffers();
  std::optional<CameraPicture> read(ArvBuffer* buffer);
  void require(const GenicamCall& call, const std::string& what) const;
  [[noreturn]] void failUnplugged() const;

  CameraIdentity identity_;
  std::string where_;
  std::atomic<bool> is_control_lost_{false};
  CameraSettings settings_;
  CameraState state_;
  PictureIntake intake_;
  GObjectOwner<ArvCamera> camera_;
  GObjectOwner<ArvStream> stream_;  // declared after the camera: it must be released first
};

GenicamCamera::GenicamCamera(const CameraIdentity& identity)
    : identity_(identity), where_(inWords(identity)) {
  GenicamCall call;
  camera_.reset(arv_camera_new(identity.address.c_str(), call));
  if (!camera_)
    throw CameraError(CameraFault::missing, "there is no such camera (" + call.words() + ")", where_,
                      "check its power and cable; the network card must be in the camera's network");
  ArvDevice* device = arv_camera_get_device(camera_.get());
  if (arv_camera_is_gv_device(camera_.get()) && !arv_gv_device_is_controller(ARV_GV_DEVICE(device)))
    throw CameraError(CameraFault::in_use, "the camera is in use by another program", where_,
                      "close that program, here or on another computer, and try again");
  g_signal_connect(device, "control-lost", G_CALLBACK(onControlLost), &is_control_lost_);
}

GenicamCamera::~GenicamCamera() {
  stop();
  if (camera_) g_signal_handlers_disconnect_by_data(arv_camera_get_device(camera_.get()), &is_control_lost_);
}

void GenicamCamera::failUnplugged() const {
  throw CameraError(CameraFault::unplugged, "the camera was unplugged", where_,
                    "check power and cable and open the cameras again");
}

void GenicamCamera::require(const GenicamCall& call, const std::string& what) const {
  if (call.isOk()) return;
  if (is_control_lost_) failUnplugged();
  throw CameraError(CameraFault::refused, what + " (" + call.words() + ")", where_,
                    "switch the camera off and on and try again");
}

CameraError GenicamCamera::wrongSize(const CameraSettings& settings, const std::string& remedy) const {
  return CameraError(CameraFault::wrong_size,
                     "the camera gives no pictures of " + std::to_string(settings.width_px) + " x " +
                         std::to_string(settings.height_px) + " px",
                     where_, remedy + "; calibrate it with a size that it has");
}

/// Centres the region on the sensor, because the calibration holds only for this part of it.
void GenicamCamera::setRegion(const CameraSettings& settings) {
  ArvCamera* camera = camera_.get();
  GenicamCall call;
  int sensor_width = 0, sensor_height = 0, x = 0, y = 0, width = 0, height = 0;
  arv_camera_get_sensor_size(camera, &sensor_width, &sensor_height, call);
  require(call, "the camera does not say how large its pictures are");
  if (settings.width_px > sensor_width || settings.height_px > sensor_height)
    throw wrongSize(settings, "its sensor has " + std::to_string(sensor_width) + " x " +
                                  std::to_string(sensor_height) + " px");
  const int step_x = std::max(1, arv_camera_get_x_offset_increment(camera, call)),
            step_y = std::max(1, arv_camera_get_y_offset_increment(camera, call));
  x = (sensor_width - settings.width_px) / 2 / step_x * step_x;
  y = (sensor_height - settings.height_px) / 2 / step_y * step_y;
  arv_camera_set_region(camera, x, y, settings.width_px, settings.height_px, call);
  arv_camera_get_region(camera, &x, &y, &width, &height, call);
  if (width != settings.width_px || height != settings.height_px)
    throw wrongSize(settings,
                    "it gives " + std::to_string(width) + " x " + std::to_string(height) + " px instead");
}

void GenicamCamera::setRate(const CameraSettings& settings) {
  GenicamCall call;
  if (!arv_camera_is_frame_rate_available(camera_.get(), call)) return;
  arv_camera_set_frame_rate(camera_.get(), settings.frames_per_s, call);
  state_.frames_per_s = arv_camera_get_frame_rate(camera_.get(), call);
  if (state_.frames_per_s < 0.95 * settings.frames_per_s)
    state_.notes.push_back(formatted("the camera gives %.0f pictures a second, %.0f were asked for",
                                     state_.frames_per_s, settings.frames_per_s));
}

CameraState GenicamCamera::configure(const CameraSettings& settings) {
  stop();
  settings_ = settings;
  state_ = {};
  setRegion(settings);
  state_.width_px = settings.width_px;
  state_.height_px = settings.height_px;
  state_.format = chooseGenicamFormat(camera_.get(), settings.format);
  if (state_.format.empty())
    throw CameraError(CameraFault::refused, "the camera has no picture format that can be read", where_,
                      "set its format to Mono8");
  GenicamCall call;
  arv_camera_set_pixel_format_from_string(camera_.get(), state_.format.c_str(), call);
  require(call, "the camera does not take its picture format");
  setTrigger(camera_.get(), settings.trigger, where_);
  if (settings.trigger == Trigger::free_run) setRate(settings);
  if (settings.is_adjusting)
    freeControls(camera_.get());
  else
    state_.controls = lockControls(camera_.get(), settings);
  state_.clock = "the camera's time stamps, fitted to this computer's clock";
  return state_;
}

void GenicamCamera::addBuffers() {
  GenicamCall call;
  const guint size = arv_camera_get_payload(camera_.get(), call);
  require(call, "the camera does not say how large its pictures are");
  for (int i = 0; i < kGenicamBuffers; ++i)
    arv_stream_push_buffer(stream_.get(), arv_buffer_new_allocate(size));
}

/// Uses plain sockets: packet sockets need root, and then listen on one network card only. The largest packet
/// that the network passes is determined once, at the start.
void GenicamCamera::prepareNetwork() {
  if (!arv_camera_is_gv_device(camera_.get())) return;
  arv_camera_gv_set_stream_options(camera_.get(), ARV_GV_STREAM_OPTION_PACKET_SOCKET_DISABLED);
  arv_camera_gv_set_packet_size_adjustment(camera_.get(), ARV_GV_PACKET_SIZE_ADJUSTMENT_ON_FAILURE_ONCE);
}

void GenicamCamera::start() {
  stop();
  intake_.restart();
  GenicamCall call;
  prepareNetwork();
  stream_.reset(arv_camera_create_stream(camera_.get(), nullptr, nullptr, call));
  require(call, "the camera gives no stream of pictures");
  addBuffers();
  arv_camera_start_acquisition(camera_.get(), call);
  require(call, "the camera does not start");
}

void GenicamCamera::stop() {
  if (!stream_) return;
  GenicamCall call;
  if (!is_control_lost_) arv_camera_stop_acquisition(camera_.get(), call);
  stream_.reset();
}

std::optional<CameraPicture> GenicamCamera::read(ArvBuffer* buffer) {
  cv::Mat grey;
  if (arv_buffer_get_status(buffer) == ARV_BUFFER_STATUS_SUCCESS) grey = decodeGrey(buffer);
  if (grey.cols != state_.width_px || grey.rows != state_.height_px) {
    intake_.noteDamaged();
    return std::nullopt;
  }
  const guint64 stamp_ns = arv_buffer_get_timestamp(buffer);
  return intake_.accept(std::move(grey), std::int64_t(arv_buffer_get_frame_id(buffer)),
                        stamp_ns == 0 ? StampClock::none : StampClock::device, 1e-9 * double(stamp_ns),
                        arrivalOf(buffer));
}

std::optional<CameraPicture> GenicamCamera::next(double timeout_s) {
  FACENAV_EXPECT(stream_, "start() first");
  const double until_s = Timestamp::now().s + timeout_s;
  for (double left_s = timeout_s; left_s > 0; left_s = until_s - Timestamp::now().s) {
    if (is_control_lost_) failUnplugged();
    ArvBuffer* buffer = arv_stream_timeout_pop_buffer(stream_.get(), guint64(1e6 * left_s));
    if (!buffer) continue;
    auto picture = read(buffer);
    arv_stream_push_buffer(stream_.get(), buffer);
    if (picture) return picture;
  }
  if (is_control_lost_) failUnplugged();
  return std::nullopt;
}

void GenicamCamera::trigger() {
  GenicamCall call;
  arv_camera_software_trigger(camera_.get(), call);
  require(call, "the camera takes no software trigger");
}

}  // namespace

std::unique_ptr<Camera> openGenicamCamera(const CameraIdentity& camera) {
  return std::make_unique<GenicamCamera>(camera);
}

}  // namespace facenav::capture
