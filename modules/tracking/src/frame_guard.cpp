#include "frame_guard.h"

#include <algorithm>
#include <cstring>
#include <opencv2/imgproc.hpp>

namespace facenav::tracking {
namespace {

constexpr double kDarkest_grey = 6.0;   // mean below it: covered or switched off
constexpr double kFlattest_grey = 2.5;  // standard deviation below it: no picture
constexpr double kNoisyShare = 0.35;    // of pixels that change between images where the sensor's noise shows
constexpr double kMoving_mm_s = 5.0;    // no head stops from this within one frame
constexpr std::size_t kHistory = 31, kLeastHistory = 2;
constexpr int kRowStep = 3;

bool isBlank(const cv::Mat& image) {
  cv::Mat small;
  cv::resize(image, small, {image.cols / 8, image.rows / 8}, 0, 0, cv::INTER_AREA);
  cv::Scalar mean, deviation;
  cv::meanStdDev(small, mean, deviation);
  return mean[0] < kDarkest_grey || deviation[0] < kFlattest_grey;
}

}  // namespace

void FrameGuard::start(const stereo::StereoFrame& reference) {
  size_ = reference.left.size();
  left_ = reference.left.clone();
  right_ = reference.right.clone();
  new_image_s_ = reference.captured.s;
  changed_.clear();
}

FrameGuard::Change FrameGuard::change(const cv::Mat& now, const cv::Mat& before, const cv::Rect& face) {
  std::size_t all = 0, in_face = 0, seen = 0, face_seen = 0;
  for (int y = 0; y < now.rows; y += kRowStep) {
    const auto *a = now.ptr(y), *b = before.ptr(y);
    const bool crosses_face = y >= face.y && y < face.y + face.height;
    const int first = crosses_face ? std::clamp(face.x, 0, now.cols) : 0;
    const int last = crosses_face ? std::clamp(face.x + face.width, 0, now.cols) : 0;
    for (int x = 0; x < now.cols; ++x) all += a[x] != b[x];
    for (int x = first; x < last; ++x) in_face += a[x] != b[x];
    seen += now.cols;
    face_seen += std::max(0, last - first);
  }
  return {double(all) / std::max<std::size_t>(1, seen),
          double(in_face) / std::max<std::size_t>(1, face_seen)};
}

bool FrameGuard::streamIsNoisy() const {
  if (changed_.size() < kLeastHistory) return false;
  auto sorted = changed_;
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  return sorted[sorted.size() / 2] > kNoisyShare;
}

std::optional<LostReason> FrameGuard::judge(const Change& left, const Change& right, double moved_mm) {
  const bool left_repeats = left.all == 0, right_repeats = right.all == 0;
  if (!left_repeats && !right_repeats) return std::nullopt;
  if (left_repeats != right_repeats) {
    const double face_change = left_repeats ? right.face : left.face;
    return streamIsNoisy() || face_change > 0.01 ? std::optional(LostReason::camera) : std::nullopt;
  }
  return streamIsNoisy() || moved_mm > 0 ? std::optional(LostReason::stale) : std::nullopt;
}

std::optional<LostReason> FrameGuard::check(const stereo::StereoFrame& frame, double speed_mm_s,
                                            const cv::Rect& left_face, const cv::Rect& right_face) {
  const auto fits = [&](const cv::Mat& image) { return image.size() == size_ && image.type() == CV_8UC1; };
  detail_ = LossDetail::no_picture;
  if (!fits(frame.left) || !fits(frame.right)) return LostReason::camera;
  const Change left = change(frame.left, left_, left_face), right = change(frame.right, right_, right_face);
  const bool is_new = left.all > 0 && right.all > 0;
  const double age_s = std::max(0.0, frame.captured.s - new_image_s_);
  const double moved_mm = speed_mm_s > kMoving_mm_s ? speed_mm_s * age_s : 0.0;
  const auto verdict = judge(left, right, moved_mm);
  if (left.all > 0) frame.left.copyTo(left_);
  if (right.all > 0) frame.right.copyTo(right_);
  if (is_new) {
    new_image_s_ = frame.captured.s;
    changed_.push_back(float(std::min(left.all, right.all)));
    if (changed_.size() > kHistory) changed_.erase(changed_.begin());
  }
  if (isBlank(frame.left) || isBlank(frame.right)) return LostReason::camera;
  detail_ = LossDetail::frozen;
  return verdict;
}

}  // namespace facenav::tracking
