#include "facenav/cameras/reduced_pair.h"

#include <opencv2/imgproc.hpp>

namespace facenav::cameras {
namespace {

constexpr int kMostReduced = 8;

CameraModel reducedCamera(const CameraModel& camera, int times) {
  CameraModel small = camera;
  small.row_time_s *= times;
  for (int axis = 0; axis < 2; ++axis) {
    small.k(axis, axis) /= times;
    small.k(axis, 2) = (camera.k(axis, 2) + 0.5) / times - 0.5;  // (0, 0) is the middle of a pixel
  }
  return small;
}

cv::Mat reducedPicture(const cv::Mat& picture, int times) {
  const cv::Size size(picture.cols / times, picture.rows / times);
  cv::Mat small;
  cv::resize(picture(cv::Rect(0, 0, size.width * times, size.height * times)), small, size, 0, 0,
             cv::INTER_AREA);
  return small;
}

}  // namespace

int reductionFor(const StereoRig& rig, double depth_mm, double least_px_per_mm) {
  int times = 1;
  while (times < kMostReduced && rig.left.k(0, 0) / depth_mm / (2 * times) >= least_px_per_mm) times *= 2;
  return times;
}

StereoRig reduced(const StereoRig& rig, int times) {
  StereoRig small = rig;
  small.width_px = rig.width_px / times;
  small.height_px = rig.height_px / times;
  small.left = reducedCamera(rig.left, times);
  small.right = reducedCamera(rig.right, times);
  if (times > 1) small.covariance.release();
  return small;
}

StereoFrame reduced(const StereoFrame& frame, int times) {
  if (times == 1) return frame;
  StereoFrame small = frame;
  small.left = reducedPicture(frame.left, times);
  small.right = reducedPicture(frame.right, times);
  return small;
}

Eigen::Vector2f inWholePicture(const Eigen::Vector2f& reduced_px, int times) {
  return float(times) * reduced_px + Eigen::Vector2f::Constant(0.5f * float(times - 1));
}

}  // namespace facenav::cameras
