#include "folder_camera.h"

#include <thread>

#include "grey_image.h"
#include "numbered_images.h"
#include "picture_intake.h"

namespace facenav::capture {
namespace fs = std::filesystem;
namespace {

class FolderCamera : public Camera {
 public:
  FolderCamera(CameraIdentity identity, std::vector<NumberedImage> images)
      : identity_(std::move(identity)), images_(std::move(images)) {}
  const CameraIdentity& identity() const override { return identity_; }
  CameraState configure(const CameraSettings& settings) override;
  void start() override;
  CameraState state() const override { return state_; }
  std::optional<CameraPicture> next(double timeout_s) override;
  void trigger() override;
  void stop() override {}
  PictureCounts counts() const override { return intake_.counts(); }
  bool isFromFiles() const override { return true; }

 private:
  const CameraIdentity identity_;
  const std::vector<NumberedImage> images_;
  CameraSettings settings_;
  CameraState state_;
  PictureIntake intake_;
  std::size_t at_ = 0;
  int bits_ = 0;  // of the first picture: a depth that changes would look like flicker
  double begun_s_ = 0.0;
};

CameraState FolderCamera::configure(const CameraSettings& settings) {
  if (settings.trigger != Trigger::free_run) trigger();
  const cv::Mat first = readGrey(images_.front().path);
  if (first.cols != settings.width_px || first.rows != settings.height_px)
    throw CameraError(CameraFault::wrong_size,
                      "the folder has no pictures of " + std::to_string(settings.width_px) + " x " +
                          std::to_string(settings.height_px) + " px",
                      identity_.address,
                      "they have " + std::to_string(first.cols) + " x " + std::to_string(first.rows) +
                          "; choose this size");
  settings_ = settings;
  bits_ = bitDepth(first);
  state_ = {};
  state_.width_px = first.cols;
  state_.height_px = first.rows;
  state_.frames_per_s = settings.frames_per_s;
  state_.format = "stream";
  state_.clock = "the numbers of the pictures, at the wanted rate";
  return state_;
}

void FolderCamera::start() {
  at_ = 0;
  intake_.restart();
  begun_s_ = Timestamp::now().s;
}

std::optional<CameraPicture> FolderCamera::next(double timeout_s) {
  if (at_ >= images_.size())
    throw CameraError(CameraFault::ended, "the pictures of the folder are at their end", identity_.address,
                      "open it again");
  const NumberedImage& image = images_[at_];
  const double due_s = begun_s_ + double(image.number - images_.front().number) / settings_.frames_per_s;
  if (settings_.is_paced) {
    const double wait_s = std::min(due_s - Timestamp::now().s, timeout_s);
    if (wait_s > 0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    if (due_s > Timestamp::now().s) return std::nullopt;
  }
  ++at_;
  const cv::Mat grey = toGrey8(readGrey(image.path), bits_);
  if (grey.cols != state_.width_px || grey.rows != state_.height_px)
    throw CameraError(CameraFault::wrong_size, "the pictures of the folder have different sizes",
                      image.path.string(), "keep the pictures of one camera only");
  auto picture = intake_.accept(grey, image.number, StampClock::file, due_s, Timestamp::now().s);
  if (picture) picture->sequence = image.number;
  return picture;
}

void FolderCamera::trigger() {
  throw CameraError(CameraFault::refused, "a folder has no trigger", identity_.address,
                    "let the cameras run free");
}

}  // namespace

std::unique_ptr<Camera> openFolderCamera(const CameraIdentity& camera) {
  const fs::path folder = camera.address;
  if (fs::is_directory(folder / "left") && fs::is_directory(folder / "right"))
    throw CameraError(CameraFault::refused, "the folder is a recording of both cameras", camera.address,
                      "give its folders left and right as the two cameras");
  auto images = listImages(folder);
  if (images.empty())
    throw CameraError(CameraFault::missing, "there is no picture in this folder", camera.address,
                      "give a folder of numbered pictures, or a video");
  return std::make_unique<FolderCamera>(camera, std::move(images));
}

}  // namespace facenav::capture
