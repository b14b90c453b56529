// Videos and network streams through OpenCV's FFmpeg. A file is played at its own pace, as a camera would.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>
#include <thread>

#include "facenav/capture/camera_backend.h"
#include "facenav/capture/stream_logins.h"
#include "facenav/core/shown_address.h"
#include "folder_camera.h"
#include "grey_image.h"
#include "picture_intake.h"

namespace facenav::capture {
namespace {

constexpr int kOpenWithin_ms = 5000, kReadWithin_ms = 2000;
constexpr double kUsualRate_hz = 30.0;  // of a file that states none
constexpr double kLateFor_s = 2.0;      // a backlog after a short stall is read in less time

bool isFile(const std::string& address) { return std::filesystem::is_regular_file(address); }

/// True for streams with the sender's clock. In others the time stamps are made up from a nominal rate.
bool carriesClock(const std::string& address) {
  static const std::array<std::string, 5> kSchemes = {"rtsp://", "rtsps://", "rtp://", "srt://", "udp://"};
  return std::any_of(kSchemes.begin(), kSchemes.end(),
                     [&](const std::string& scheme) { return address.rfind(scheme, 0) == 0; });
}

/// Reduces the delay of the stream that is opened while this lives: by default FFmpeg analyses five seconds
/// of an unknown stream before the first picture, and then holds pictures back. A file would lose a picture.
class WithoutDelay {
 public:
  explicit WithoutDelay(bool is_network) : lock_(mutex_), is_set_(is_network && !std::getenv(kVariable)) {
    if (is_set_)
      ::setenv(kVariable, "rtsp_transport;tcp|analyzeduration;300000|probesize;300000|fflags;nobuffer", 1);
  }
  ~WithoutDelay() {
    if (is_set_) ::unsetenv(kVariable);
  }
  WithoutDelay(const WithoutDelay&) = delete;
  WithoutDelay& operator=(const WithoutDelay&) = delete;

 private:
  static constexpr const char* kVariable = "OPENCV_FFMPEG_CAPTURE_OPTIONS";
  static std::mutex mutex_;  // the variable is one for all threads
  std::lock_guard<std::mutex> lock_;
  bool is_set_;
};
std::mutex WithoutDelay::mutex_;

/// What to do about a stream that does not open.
std::string remedyOf(const CameraIdentity& stream, const std::string& opening) {
  if (isFile(stream.address)) return "is the file whole, and its codec installed?";
  const bool has_user_only = opening.find('@') != std::string::npos && opening == shownAddress(opening);
  if (has_user_only)
    return "is it switched on? No password is kept for it: type the address once with it, name:password@";
  return "check the address, and that the camera is switched on";
}

cv::VideoCapture openStream(const CameraIdentity& stream) {
  const std::string& address = stream.address;
  const std::string opening = isFile(address) ? address : StreamLogins().openingAddress(stream);
  static const bool is_quiet = ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0) == 0;
  (void)is_quiet;
  const WithoutDelay options(!isFile(address));
  const auto level = cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::VideoCapture video(
      opening, cv::CAP_FFMPEG,
      {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kOpenWithin_ms, cv::CAP_PROP_READ_TIMEOUT_MSEC, kReadWithin_ms});
  cv::utils::logging::setLogLevel(level);
  if (!video.isOpened())
    throw CameraError(CameraFault::missing, "the stream cannot be opened", address,
                      remedyOf(stream, opening));
  return video;
}

class StreamCamera : public Camera {
 public:
  explicit StreamCamera(CameraIdentity identity)
      : identity_(std::move(identity)), video_(openStream(identity_)) {}
  const CameraIdentity& identity() const override { return identity_; }
  CameraState configure(const CameraSettings& settings) override;
  void start() override;
  CameraState state() const override { return state_; }
  std::optional<CameraPicture> next(double timeout_s) override;
  void trigger() override;
  void stop() override { is_running_ = false; }
  PictureCounts counts() const override { return intake_.counts(); }
  bool isFromFiles() const override { return isFile(identity_.address); }

 private:
  [[noreturn]] void failAtEnd() const;
  void requireInTime() const;
  bool grab();
  double fileStamp_s();
  std::optional<CameraPicture> retrieve();

  CameraIdentity identity_;
  cv::VideoCapture video_;
  CameraState state_;
  PictureIntake intake_;
  std::int64_t sequence_ = 0;
  double begun_s_ = 0.0;
  std::optional<double> due_s_;  // due time of the grabbed picture
  double last_stamp_s_ = -1.0;   // of a file, from its start
  bool is_running_ = false, has_started_ = false, is_paced_ = true;
};

CameraState StreamCamera::configure(const CameraSettings& settings) {
  stop();
  state_ = {};
  state_.width_px = int(video_.get(cv::CAP_PROP_FRAME_WIDTH));
  state_.height_px = int(video_.get(cv::CAP_PROP_FRAME_HEIGHT));
  if (state_.width_px != settings.width_px || state_.height_px != settings.height_px)
    throw CameraError(CameraFault::wrong_size,
                      "the stream gives no pictures of " + std::to_string(settings.width_px) + " x " +
                          std::to_string(settings.height_px) + " px",
                      identity_.address,
                      "it has " + std::to_string(state_.width_px) + " x " + std::to_string(state_.height_px) +
                          (isFromFiles() ? "; choose this size" : "; set the sender to the calibrated size"));
  if (settings.trigger != Trigger::free_run) trigger();
  is_paced_ = settings.is_paced || !isFromFiles();
  state_.frames_per_s = video_.get(cv::CAP_PROP_FPS);
  state_.format = "stream";
  state_.clock = isFile(identity_.address) ? "the file's time stamps, from its start"
                 : carriesClock(identity_.address)
                     ? "the sender's time stamps, fitted to this computer's clock"
                     : "time of arrival; this kind of stream has no time stamps";
  if (!isFromFiles())
    state_.notes.push_back("exposure, gain, focus and white balance of a stream are set at its sender");
  return state_;
}

void StreamCamera::start() {
  if (has_started_) {
    video_.release();  // first: many senders serve one receiver
    video_ = openStream(identity_);
  }
  has_started_ = is_running_ = true;
  intake_.restart();
  due_s_.reset();
  last_stamp_s_ = -1.0;
  sequence_ = 0;
  begun_s_ = Timestamp::now().s;
}

void StreamCamera::failAtEnd() const {
  if (isFile(identity_.address))
    throw CameraError(CameraFault::ended, "the video is at its end", identity_.address, "open it again");
  throw CameraError(CameraFault::unplugged, "the stream broke off", identity_.address,
                    "check the network and the camera, then open the cameras again");
}

/// Throws CameraError hung if the stream is late: a stream that is opened anew begins with the present.
void StreamCamera::requireInTime() const {
  if (intake_.lateFor_s() > kLateFor_s)
    throw CameraError(CameraFault::hung, "the pictures of the stream come too late", identity_.address,
                      "let the sender send fewer or smaller pictures, or close other programs");
}

/// Time of the grabbed picture from the file's start. Some files have no time stamps: there the rate counts.
double StreamCamera::fileStamp_s() {
  const double stamp_s = 1e-3 * video_.get(cv::CAP_PROP_POS_MSEC);
  const double rate_hz = state_.frames_per_s > 0 ? state_.frames_per_s : kUsualRate_hz;
  last_stamp_s_ = stamp_s > last_stamp_s_ ? stamp_s : last_stamp_s_ + 1.0 / rate_hz;
  return last_stamp_s_;
}

bool StreamCamera::grab() {
  if (due_s_) return true;
  if (!video_.grab()) failAtEnd();
  due_s_ = isFromFiles() ? begun_s_ + fileStamp_s() : Timestamp::now().s;
  return true;
}

std::optional<CameraPicture> StreamCamera::retrieve() {
  const bool has_clock = carriesClock(identity_.address);
  const double stamp_s = has_clock ? 1e-3 * video_.get(cv::CAP_PROP_POS_MSEC) : *due_s_;
  const StampClock clock = isFromFiles() ? StampClock::file
                           : has_clock   ? StampClock::device
                                         : StampClock::steady;
  due_s_.reset();
  cv::Mat image;
  const std::int64_t sequence = sequence_++;
  if (!video_.retrieve(image) || image.cols != state_.width_px || image.rows != state_.height_px) {
    intake_.noteDamaged();
    return std::nullopt;
  }
  return intake_.accept(toGrey8(image, 16).clone(), sequence, clock, stamp_s, Timestamp::now().s);
}

std::optional<CameraPicture> StreamCamera::next(double timeout_s) {
  FACENAV_EXPECT(is_running_, "start() first");
  const double until_s = Timestamp::now().s + timeout_s;
  do {
    grab();
    const double wait_s = is_paced_ ? std::min(*due_s_, until_s) - Timestamp::now().s : 0.0;
    if (wait_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    if (is_paced_ && *due_s_ > until_s) return std::nullopt;
    auto picture = retrieve();
    requireInTime();
    if (picture) return picture;
  } while (Timestamp::now().s < until_s);
  return std::nullopt;
}

void StreamCamera::trigger() {
  throw CameraError(CameraFault::refused, "a stream has no trigger", identity_.address,
                    "let the cameras run free");
}

class StreamBackend : public CameraBackend {
 public:
  std::vector<FoundCamera> list() override { return {}; }
  std::unique_ptr<Camera> open(const CameraIdentity& camera) override {
    if (std::filesystem::is_directory(camera.address)) return openFolderCamera(camera);
    if (isFile(camera.address) && isImageFile(camera.address))
      throw CameraError(CameraFault::refused, "this is one picture, not a film", camera.address,
                        "give a video, or the folder of the pictures");
    return std::make_unique<StreamCamera>(camera);
  }
};

}  // namespace

std::unique_ptr<CameraBackend> makeStreamBackend() { return std::make_unique<StreamBackend>(); }

}  // namespace facenav::capture
