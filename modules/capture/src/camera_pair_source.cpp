#include "facenav/capture/camera_pair_source.h"

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>

#include "facenav/core/error.h"
#include "grey_image.h"
#include "recording_frames.h"

namespace facenav::capture {
namespace {

std::string nameOf(int index) { return "camera " + std::to_string(index); }

cv::VideoCapture openCamera(const cameras::StereoRig& rig, int index) {
  const auto level = cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::VideoCapture camera(index);
  cv::utils::logging::setLogLevel(level);
  if (!camera.isOpened()) throw Error("camera cannot be opened", nameOf(index), "is it plugged in and free?");
  camera.set(cv::CAP_PROP_FRAME_WIDTH, rig.width_px);
  camera.set(cv::CAP_PROP_FRAME_HEIGHT, rig.height_px);
  return camera;
}

class CameraPairSource : public FrameSource {
 public:
  CameraPairSource(const cameras::StereoRig& rig, int left_index, int right_index)
      : rig_(rig),
        left_index_(left_index),
        right_index_(right_index),
        left_(openCamera(rig, left_index)),
        right_(openCamera(rig, right_index)) {}
  const cameras::StereoRig& rig() const override { return rig_; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    auto frame = std::make_shared<cameras::StereoFrame>();
    const Timestamp before = Timestamp::now();
    const bool has_left = left_.grab(), has_right = right_.grab();
    frame->captured = {0.5 * (before.s + Timestamp::now().s)};
    frame->left = decode(left_, left_index_, has_left);
    frame->right = decode(right_, right_index_, has_right);
    frame->number = number_++;
    requireRigSize(rig_, frame->left, frame->right, nameOf(left_index_) + ", " + nameOf(right_index_));
    return frame;
  }

 private:
  static cv::Mat decode(cv::VideoCapture& camera, int index, bool is_grabbed) {
    cv::Mat image;
    if (!is_grabbed || !camera.retrieve(image) || image.empty())
      throw Error("camera gives no image", nameOf(index), "check the cable");
    return toGrey8(image, 16).clone();
  }

  cameras::StereoRig rig_;
  int left_index_, right_index_;
  cv::VideoCapture left_, right_;
  std::int64_t number_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> openCameraPair(const cameras::StereoRig& rig, int left_index, int right_index) {
  if (left_index == right_index)
    throw Error("left and right are the same camera", nameOf(left_index), "give two different indices");
  return std::make_unique<CameraPairSource>(rig, left_index, right_index);
}

}  // namespace facenav::capture
