#include "block_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "facenav/core/parallel_for.h"
#include "kernels/block_kernel.h"
#include "normalised_image.h"
#include "strips.h"

namespace facenav::stereo {

namespace {

constexpr int kBlockUniqueness_256 = 10;
constexpr float kNeighbour_px = 2.0f;  // largest difference of neighbouring blocks of one surface (slope 0.5)
constexpr int kFewestNeighbours = 3;   // of the 8 neighbours
const float kNone = std::numeric_limits<float>::quiet_NaN();

// Keeps a block if enough of its neighbours agree, and if no nearer surface maps to the same place in the
// right image with a smaller cost.
cv::Mat agreeing(const cv::Mat& found) {
  cv::Mat kept(found.size(), CV_32F, cv::Scalar(kNone));
  for (int y = 0; y < found.rows; ++y)
    for (int x = 0; x < found.cols; ++x) {
      const float d = found.at<float>(y, x);
      if (!(d >= 0)) continue;
      int agree = -1;  // does not count itself
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, found.rows - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, found.cols - 1); ++u)
          agree += std::abs(found.at<float>(v, u) - d) < kNeighbour_px;
      if (agree >= kFewestNeighbours) kept.at<float>(y, x) = d;
    }
  return kept;
}

// Fills holes with repeated means of the known values over 2 x 2, then back from the coarser level to the
// finer one.
cv::Mat filled(const cv::Mat& holed) {
  if (holed.rows <= 1 && holed.cols <= 1) return holed;
  cv::Mat half((holed.rows + 1) / 2, (holed.cols + 1) / 2, CV_32F);
  for (int y = 0; y < half.rows; ++y)
    for (int x = 0; x < half.cols; ++x) {
      float sum = 0, count = 0;
      for (int v = 2 * y; v < std::min(2 * y + 2, holed.rows); ++v)
        for (int u = 2 * x; u < std::min(2 * x + 2, holed.cols); ++u)
          if (const float d = holed.at<float>(v, u); !std::isnan(d)) {
            sum += d;
            count += 1;
          }
      half.at<float>(y, x) = count > 0 ? sum / count : kNone;
    }
  const cv::Mat coarse = filled(half);
  cv::Mat full = holed.clone();
  for (int y = 0; y < full.rows; ++y)
    for (int x = 0; x < full.cols; ++x)
      if (std::isnan(full.at<float>(y, x))) full.at<float>(y, x) = coarse.at<float>(y / 2, x / 2);
  return full;
}

cv::Mat agreeingBlocks(const Rectification& rectification, const RectifiedPair& pair,
                       const block::Kernel& kernel) {
  using namespace block;
  const int columns = (pair.left.cols + kBlock - 1) / kBlock, rows = (pair.left.rows + kBlock - 1) / kBlock;
  const int disparities =
      (rectification.disparities + kDisparityBlock - 1) / kDisparityBlock * kDisparityBlock;
  const cv::Mat left = normalisedImage(pair.left, rectification.left_mask, kNormalisedMiddle, rows * kBlock,
                                       columns * kBlock, 0, false);
  // Mirrored: column width - 1 - x + d is the right pixel x - d; the padding covers the added disparities.
  const int width = pair.left.cols;
  const int lead = columns * kBlock - width;  // mirrored columns before those of the image
  const cv::Mat right = normalisedImage(pair.right, rectification.right_mask, kNormalisedInvalid,
                                        rows * kBlock, columns * kBlock + disparities, lead, true);
  Images images{left.data, right.data + lead, int(left.step), int(right.step), columns, rows,
                width,     disparities};
  cv::Mat found(rows, columns, CV_32F);
  const int strips = stripsFor(rows);
  parallelRanges(0, strips, [&](int begin, int end) {
    std::vector<std::uint16_t> scratch(std::size_t(scratchSize(columns, disparities)) / 2 + 1);
    for (int i = begin; i < end; ++i)
      kernel.search(images, rows * i / strips, rows * (i + 1) / strips, kBlockUniqueness_256,
                    reinterpret_cast<std::uint8_t*>(scratch.data()), found.ptr<float>(), int(found.step1()));
  });
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const int centre_y = std::min(y * kBlock + 2, pair.left.rows - 1),
                centre_x = std::min(x * kBlock + 2, width - 1);
      float& d = found.at<float>(y, x);
      if (!rectification.left_mask.at<std::uint8_t>(centre_y, centre_x) ||
          d > float(rectification.disparities - 1))
        d = kNone;
    }
  return agreeing(found);
}

}  // namespace

cv::Mat searchBlocks(const Rectification& rectification, const RectifiedPair& pair,
                     const block::Kernel& kernel) {
  return filled(agreeingBlocks(rectification, pair, kernel));
}

cv::Mat blocksOf(const Rectification& r, const cv::Size& image, const PointCloud<Camera>& surface) {
  using block::kBlock;
  cv::Mat blocks((image.height + kBlock - 1) / kBlock, (image.width + kBlock - 1) / kBlock, CV_32F,
                 cv::Scalar(kNone));
  for (const auto& point : surface.points_mm) {
    const Eigen::Vector3d p = r.rectified_R_camera * Eigen::Vector3d(point);
    if (!(p.z() > 0)) continue;
    const double x = r.f_px * p.x() / p.z() + r.cx_left_px, y = r.f_px * p.y() / p.z() + r.cy_px;
    if (!(x >= 0 && y >= 0 && x < image.width && y < image.height)) continue;
    const float disparity = float(r.f_px * r.baseline_mm / p.z() + r.offset_px());
    float& nearest = blocks.at<float>(int(y) / kBlock, int(x) / kBlock);
    if (!(nearest >= disparity)) nearest = disparity;
  }
  return filled(blocks);
}

int matchedBlocks(const Rectification& rectification, const RectifiedPair& pair) {
  const cv::Mat blocks = agreeingBlocks(rectification, pair, block::kernel());
  return cv::countNonZero(blocks == blocks);  // NaN differs from itself
}

}  // namespace facenav::stereo
