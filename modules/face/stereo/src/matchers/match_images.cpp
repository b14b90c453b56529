#include "match_images.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core/utility.hpp>

#include "facenav/core/parallel_for.h"
#include "kernels/plane_kernel.h"

namespace facenav::stereo {
namespace {

// Cubic B-spline coefficients along the rows: the inverse filter's two-sided impulse response, cut where it
// has fallen to 1e-4 (Unser 1999).
cv::Mat splineAlongRows(const cv::Mat& image) {
  constexpr int kRadius = planes::kSplineRadius;
  float weights[kRadius + 1];
  float sum = 0;
  for (int i = 0; i <= kRadius; ++i) {
    weights[i] = float(std::pow(std::sqrt(3.0) - 2.0, i));
    sum += (i ? 2 : 1) * weights[i];
  }
  for (float& weight : weights) weight /= sum;
  const planes::Kernel& kernel = planes::kernel();
  cv::Mat coefficients(image.size(), CV_32F);
  const int width = image.cols;
  parallelRanges(0, image.rows, [&](int begin, int end) {
    std::vector<float> padded(std::size_t(width) + 2 * kRadius);
    for (int y = begin; y < end; ++y) {
      const float* row = image.ptr<float>(y);
      std::copy(row, row + width, padded.begin() + kRadius);
      for (int i = 1; i <= kRadius; ++i) {
        padded[kRadius - i] = row[std::min(i, width - 1)];
        padded[kRadius + width - 1 + i] = row[std::max(width - 1 - i, 0)];
      }
      kernel.spline_row(padded.data() + kRadius, weights, width, coefficients.ptr<float>(y));
    }
  });
  return coefficients;
}

// First and one past the last valid pixel of each row. The valid part of a row is contiguous.
void validColumns(const cv::Mat& mask, std::vector<std::int32_t>& first, std::vector<std::int32_t>& end) {
  first.assign(mask.rows, 0);
  end.assign(mask.rows, 0);
  for (int y = 0; y < mask.rows; ++y) {
    const std::uint8_t* row = mask.ptr<std::uint8_t>(y);
    int x = 0, stop = mask.cols;
    while (x < stop && !row[x]) ++x;
    while (stop > x && !row[stop - 1]) --stop;
    first[y] = x;
    end[y] = stop;
  }
}

}  // namespace

MatchImages::MatchImages(const Rectification& rectification, const RectifiedPair& pair)
    : left_(pair.left), right_(splineAlongRows(pair.right)) {
  validColumns(rectification.left_mask, left_first_, left_end_);
  validColumns(rectification.right_mask, right_first_, right_end_);
  rows_ = {left_.ptr<float>(), right_.ptr<float>(), int(left_.step1()),  int(right_.step1()),
           left_.cols,         left_.rows,          right_.cols,         rectification.disparities,
           left_first_.data(), left_end_.data(),    right_first_.data(), right_end_.data()};
}

}  // namespace facenav::stereo
