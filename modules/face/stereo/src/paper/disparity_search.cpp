#include "disparity_search.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "facenav/core/error.h"
#include "facenav/core/parallel_for.h"
#include "paper/ssd_kernel.h"

namespace facenav::stereo {
namespace {

constexpr int kNormalisingWindow_px = 15;
constexpr float kFlatness_grey = 2.0f;  // contrast below this is noise and is not stretched
constexpr float kLevelsPerSigma = 9.0f;
constexpr int kMiddle = 32, kHighest = 63,
              kInvalid = 255;  // largest difference to every valid level, for invalid right pixels
constexpr int kUniqueness_256 = 10;

// Normalises to local mean 0 and standard deviation 1, as 6 bits round kMiddle. This makes the SSD
// independent of gain and offset.
cv::Mat normalise(const cv::Mat& image, const cv::Mat& mask, int invalid) {
  cv::Mat mean, square;
  const cv::Size window(kNormalisingWindow_px, kNormalisingWindow_px);
  cv::boxFilter(image, mean, CV_32F, window, {-1, -1}, true, cv::BORDER_REPLICATE);
  cv::sqrBoxFilter(image, square, CV_32F, window, {-1, -1}, true, cv::BORDER_REPLICATE);
  cv::Mat normalised(image.size(), CV_8U);
  parallelRanges(0, image.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const float *in = image.ptr<float>(y), *m = mean.ptr<float>(y), *s = square.ptr<float>(y);
      const std::uint8_t* is_valid = mask.ptr<std::uint8_t>(y);
      std::uint8_t* out = normalised.ptr<std::uint8_t>(y);
      for (int x = 0; x < image.cols; ++x) {
        const float sigma = std::sqrt(std::max(s[x] - m[x] * m[x], 0.0f));
        const float level =
            float(kMiddle) + 0.5f + kLevelsPerSigma * (in[x] - m[x]) / (sigma + kFlatness_grey);
        out[x] = is_valid[x] ? std::uint8_t(std::clamp(level, 0.0f, float(kHighest))) : std::uint8_t(invalid);
      }
    }
  });
  return normalised;
}

cv::Mat padded(const cv::Mat& image, int rows, int left, int right, int value) {
  cv::Mat out;
  cv::copyMakeBorder(image, out, rows, rows, left, right, cv::BORDER_CONSTANT, cv::Scalar(value));
  return out;
}

struct StripMemory {
  explicit StripMemory(const ssd::Images& im)
      : column(std::size_t(im.width + 2 * im.half) * im.disparities),
        box(im.disparities),
        right_cost(im.width + im.disparities),
        right_match(im.width + im.disparities),
        zeros(ssd::kDisparityBlock, 0) {}
  ssd::Scratch scratch() {
    return {column.data(), box.data(), right_cost.data(), right_match.data(), zeros.data()};
  }
  std::vector<std::uint16_t> column, box, right_cost, right_match, zeros;
};

}  // namespace

cv::Mat searchDisparities(const Rectification& rectification, const RectifiedPair& pair, int window_px) {
  FACENAV_EXPECT(window_px % 2 == 1 && window_px >= 5 && window_px <= 11,
                 "the search window is odd, 5 to 11 px");
  const int half = window_px / 2, padding = ssd::kDisparityBlock;
  const int disparities = (rectification.disparities + padding - 1) / padding * padding;
  const int extra =
      disparities - rectification.disparities;  // further columns to the left that the padding adds
  const cv::Mat left =
      padded(normalise(pair.left, rectification.left_mask, kMiddle), half + 1, half, half, kMiddle);
  cv::Mat right = padded(normalise(pair.right, rectification.right_mask, kInvalid), half + 1, half + extra,
                         half, kInvalid);
  cv::flip(right, right, 1);
  ssd::Images images{left.ptr<std::uint8_t>(half + 1),
                     right.ptr<std::uint8_t>(half + 1),
                     int(left.step),
                     int(right.step),
                     pair.left.cols,
                     pair.left.rows,
                     disparities,
                     half};
  cv::Mat disparity(pair.left.size(), CV_16S);
  // The number of strips is fixed, so that the result does not depend on the number of cores.
  constexpr int kStrips = 8;
  parallelRanges(0, kStrips, [&](int begin, int end) {
    StripMemory memory(images);
    for (int i = begin; i < end; ++i)
      ssd::kernel().search_rows(images, memory.scratch(), images.height * i / kStrips,
                                images.height * (i + 1) / kStrips, kUniqueness_256,
                                disparity.ptr<std::int16_t>(), int(disparity.step1()));
  });
  for (int y = 0; y < disparity.rows; ++y)
    for (int x = 0; x < disparity.cols; ++x) {
      std::int16_t& d = disparity.at<std::int16_t>(y, x);
      if (!rectification.left_mask.at<std::uint8_t>(y, x) || d >= rectification.disparities) d = -1;
    }
  return disparity;
}

}  // namespace facenav::stereo
