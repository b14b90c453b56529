#include "frame_guard.h"

#include <algorithm>

#include "facenav/core/robust_statistics.h"

namespace facenav::head_tracking {
namespace {

constexpr double kFlattest_grey = 2.5;  // standard deviation; lower: covered, switched off, or no picture
constexpr double kNoisyShare = 0.35;    // share of changed pixels from which on noise is visible
constexpr double kMoving_mm_s = 5.0;    // a faster head does not stop within one frame
constexpr std::size_t kHistory = 31;
constexpr int kRowStep = 3;

constexpr int kGuardBlock_px = 8, kBlockStep_px = 24;  // squares whose means distinguish a picture from noise

bool isBlank(const cv::Mat& image) {
  double sum = 0, squares = 0;
  int blocks = 0;
  for (int y0 = 0; y0 + kGuardBlock_px <= image.rows; y0 += kBlockStep_px)
    for (int x0 = 0; x0 + kGuardBlock_px <= image.cols; x0 += kBlockStep_px) {
      int block = 0;
      for (int y = y0; y < y0 + kGuardBlock_px; ++y)
        for (int x = 0; x < kGuardBlock_px; ++x) block += image.ptr(y)[x0 + x];
      const double mean = double(block) / (kGuardBlock_px * kGuardBlock_px);
      sum += mean, squares += mean * mean, ++blocks;
    }
  if (blocks == 0) return true;
  const double mean = sum / blocks;
  return squares / blocks - mean * mean < kFlattest_grey * kFlattest_grey;
}

// Every kRowStep-th row, without a copy.
cv::Mat someRows(const cv::Mat& image) {
  return cv::Mat((image.rows + kRowStep - 1) / kRowStep, image.cols, image.type(), image.data,
                 kRowStep * image.step);
}

}  // namespace

void FrameGuard::start(const cameras::StereoFrame& reference) {
  size_ = reference.left.size();
  left_ = someRows(reference.left).clone();
  right_ = someRows(reference.right).clone();
  new_image_s_ = reference.captured.s;
  changed_.clear();
}

FrameGuard::Change FrameGuard::change(const cv::Mat& now, const cv::Mat& before, const cv::Rect& face) {
  cv::Mat differs;
  cv::compare(now, before, differs, cv::CMP_NE);
  const cv::Rect in_rows(face.x, (face.y + kRowStep - 1) / kRowStep, face.width, face.height / kRowStep);
  const cv::Rect seen = in_rows & cv::Rect({}, differs.size());
  return {double(cv::countNonZero(differs)) / std::max<std::size_t>(1, differs.total()),
          seen.empty() ? 0.0 : double(cv::countNonZero(differs(seen))) / seen.area()};
}

bool FrameGuard::streamIsNoisy() const { return upperMedian(changed_) > kNoisyShare; }

std::optional<LostReason> FrameGuard::judge(const Change& left, const Change& right, double moved_mm) {
  const bool left_repeats = left.all == 0, right_repeats = right.all == 0;
  if (!left_repeats && !right_repeats) return std::nullopt;
  if (left_repeats != right_repeats) {
    const double face_change = left_repeats ? right.face : left.face;
    return streamIsNoisy() || face_change > 0.01 ? std::optional(LostReason::camera) : std::nullopt;
  }
  return streamIsNoisy() || moved_mm > 0 ? std::optional(LostReason::stale) : std::nullopt;
}

std::optional<LostReason> FrameGuard::check(const cameras::StereoFrame& frame, double speed_mm_s,
                                            const cv::Rect& left_face, const cv::Rect& right_face) {
  const auto fits = [&](const cv::Mat& image) { return image.size() == size_ && image.type() == CV_8UC1; };
  detail_ = LossDetail::no_picture;
  if (!fits(frame.left) || !fits(frame.right)) return LostReason::camera;
  const cv::Mat now[2] = {someRows(frame.left), someRows(frame.right)};
  const Change left = change(now[0], left_, left_face), right = change(now[1], right_, right_face);
  const bool is_new = left.all > 0 && right.all > 0;
  const double age_s = std::max(0.0, frame.captured.s - new_image_s_);
  const double moved_mm = speed_mm_s > kMoving_mm_s ? speed_mm_s * age_s : 0.0;
  const auto verdict = judge(left, right, moved_mm);
  if (left.all > 0) now[0].copyTo(left_);
  if (right.all > 0) now[1].copyTo(right_);
  if (is_new) {
    new_image_s_ = frame.captured.s;
    changed_.push_back(float(std::min(left.all, right.all)));
    if (changed_.size() > kHistory) changed_.erase(changed_.begin());
  }
  if (isBlank(frame.left) || isBlank(frame.right)) return LostReason::camera;
  detail_ = LossDetail::frozen;
  return verdict;
}

}  // namespace facenav::head_tracking
