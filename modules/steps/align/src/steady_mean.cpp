#include "steady_mean.h"

#include <opencv2/imgproc.hpp>
#include <optional>

namespace facenav::steps {
namespace {

// Largest shift of a still face: a fifth of the blur of a lens in focus. A camera's noise moves the estimate
// by some hundredths.
constexpr double kSteady_px = 0.15;
constexpr double kSmooth_px = 1.5;  // blur of the compared parts: less noise, and a shift of 1 px is small
constexpr int kLeastSide_px = 32;

cv::Mat cut(const cv::Mat& grey, const cv::Rect& region) {
  cv::Mat part;
  grey(region).convertTo(part, CV_32F);
  return part;
}

cv::Mat smooth(const cv::Mat& part) {
  cv::Mat blurred;
  cv::GaussianBlur(part, blurred, {}, kSmooth_px);
  return blurred;
}

/// Estimates the shift of `part` relative to `newest`, to first order (Lucas and Kanade), px.
double shift_px(const cv::Mat& newest, const cv::Mat& across, const cv::Mat& down, const cv::Mat& part) {
  const cv::Mat change = newest - part;
  const cv::Matx22d gradients(across.dot(across), across.dot(down), across.dot(down), down.dot(down));
  const cv::Vec2d right(across.dot(change), down.dot(change));
  return cv::norm(gradients.inv(cv::DECOMP_SVD) * right);
}

/// A part of a picture in quarters: a face that turns about its middle moves the quarters but not their mean.
class Quarters {
 public:
  explicit Quarters(const cv::Mat& newest) : newest_(smooth(newest)) {
    cv::Sobel(newest_, across_, CV_32F, 1, 0, 3, 0.125);
    cv::Sobel(newest_, down_, CV_32F, 0, 1, 3, 0.125);
  }
  bool areSteadyIn(const cv::Mat& part) const {
    const cv::Mat other = smooth(part);
    const int half_x = other.cols / 2, half_y = other.rows / 2;
    for (const int x : {0, half_x})
      for (const int y : {0, half_y}) {
        const cv::Rect quarter(x, y, half_x, half_y);
        if (!(shift_px(newest_(quarter), across_(quarter), down_(quarter), other(quarter)) < kSteady_px))
          return false;
      }
    return true;
  }

 private:
  cv::Mat newest_, across_, down_;
};

/// The sum of one camera's regions.
struct SteadySum {
  SteadySum(const cv::Mat& grey, const cv::Rect& face) : region(face & cv::Rect({0, 0}, grey.size())) {
    if (!isUsable()) return;
    sum = cut(grey, region);
    quarters.emplace(sum);
  }
  bool isUsable() const { return region.width >= kLeastSide_px && region.height >= kLeastSide_px; }
  /// Replaces the newest picture by the mean of `count` pictures.
  void put(int count, const cv::Rect& kept, cv::Mat& grey) const {
    const cv::Rect unchanged = kept & region;
    const cv::Mat own = grey(unchanged).clone();
    sum.convertTo(grey(region), CV_8U, 1.0 / count);
    if (!own.empty()) own.copyTo(grey(unchanged));
  }

  cv::Rect region;
  cv::Mat sum;
  std::optional<Quarters> quarters;
};

}  // namespace

SteadyMean steadyMean(const std::deque<cameras::StereoFrame>& frames, const SteadyRegion& left,
                      const SteadyRegion& right) {
  SteadyMean result{frames.back()};
  cameras::StereoFrame& mean = result.frame;
  mean.left = frames.back().left.clone();
  mean.right = frames.back().right.clone();
  SteadySum in_left(mean.left, left.face), in_right(mean.right, right.face);
  if (!in_left.isUsable() || !in_right.isUsable()) return result;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    const cv::Mat left_part = cut(frames[i].left, in_left.region),
                  right_part = cut(frames[i].right, in_right.region);
    if (!in_left.quarters->areSteadyIn(left_part) || !in_right.quarters->areSteadyIn(right_part)) continue;
    in_left.sum += left_part;
    in_right.sum += right_part;
    ++result.pictures;
  }
  in_left.put(result.pictures, left.kept, mean.left);
  in_right.put(result.pictures, right.kept, mean.right);
  return result;
}

}  // namespace facenav::steps
