#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "disparity_filter.h"
#include "facenav/core/parallel_for.h"
#include "kernels/sgm_kernel.h"
#include "matchers.h"

namespace facenav::stereo {
namespace {

constexpr int kCensusAcross = 4, kCensusDown = 3;  // 9 x 7: 62 comparisons
constexpr std::uint8_t kUnknown = 31;              // distance if one of the images has no valid pixel
constexpr int kSmallStep = 7, kLargeStep = 60, kLeastLargeStep = 18;
constexpr float kEdge_grey = 10.0f;  // a grey step that halves the cost of a disparity step
constexpr float kMeasured_px = 0.25f,
                kFilled_px = 1.0f;  // predicted deviations of matches and of filled holes
const float kNone = std::numeric_limits<float>::quiet_NaN();

// Census words, one per pixel, row by row. Each bit: is one neighbour darker than the middle?
std::vector<std::uint64_t> censusOf(const cv::Mat& image) {
  cv::Mat padded;
  cv::copyMakeBorder(image, padded, kCensusDown, kCensusDown, kCensusAcross, kCensusAcross,
                     cv::BORDER_REPLICATE);
  std::vector<std::uint64_t> census(image.total(), 0);
  parallelRanges(0, image.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const float* middle = image.ptr<float>(y);
      std::uint64_t* out = census.data() + std::size_t(y) * image.cols;
      for (int v = 0; v <= 2 * kCensusDown; ++v)
        for (int u = 0; u <= 2 * kCensusAcross; ++u) {
          if (v == kCensusDown && u == kCensusAcross) continue;
          const float* row = padded.ptr<float>(y + v) + u;
          for (int x = 0; x < image.cols; ++x) out[x] = out[x] << 1 | std::uint64_t(row[x] < middle[x]);
        }
    }
  });
  return census;
}

// Costs of all disparities of all pixels, and the sums of their paths.
class Volume {
 public:
  Volume(const Rectification& rectification, const RectifiedPair& pair)
      : left_(pair.left),
        width_(pair.left.cols),
        height_(pair.left.rows),
        disparities_((rectification.disparities + 15) / 16 * 16),
        costs_(std::size_t(width_) * height_ * disparities_),
        totals_(costs_.size(), 0) {
    fillCosts(rectification, pair);
    // Four directions on the way down and four on the way up: from the left, and from three pixels of the row
    // above.
    for (const int down : {1, -1}) sweep(down);
  }

  int disparities() const { return disparities_; }
  const std::int16_t* totals(int x, int y) const { return totals_.data() + at(x, y); }

 private:
  std::size_t at(int x, int y) const { return (std::size_t(y) * width_ + x) * disparities_; }

  void fillCosts(const Rectification& r, const RectifiedPair& pair);
  void sweep(int down);

  cv::Mat left_;
  int width_, height_, disparities_;
  std::vector<std::uint8_t> costs_;
  std::vector<std::int16_t> totals_;
};

void Volume::fillCosts(const Rectification& r, const RectifiedPair& pair) {
  const auto left = censusOf(pair.left), right = censusOf(pair.right);
  const sgm::Kernel& kernel = sgm::kernel();
  parallelRanges(0, height_, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::uint64_t *left_row = left.data() + std::size_t(y) * width_,
                          *right_row = right.data() + std::size_t(y) * pair.right.cols;
      for (int x = 0; x < width_; ++x) {
        std::uint8_t* cost = costs_.data() + at(x, y);
        // Column r.disparities of the right image corresponds to column 0 of the left one, so all reads are
        // inside.
        kernel.distances(left_row[x], right_row + x + r.disparities, r.disparities, cost);
        const std::uint8_t* right_mask = r.right_mask.ptr<std::uint8_t>(y) + x + r.disparities;
        const bool is_seen = r.left_mask.at<std::uint8_t>(y, x) != 0;
        for (int d = 0; d < disparities_; ++d)
          if (!is_seen || d >= r.disparities || !right_mask[-d]) cost[d] = kUnknown;
      }
    }
  });
}

void Volume::sweep(int down) {
  const sgm::Step step = sgm::kernel().step;
  const int pitch = disparities_ + 2 * sgm::kPadding;
  // Per column: the path from the row before straight down, and along both diagonals; two rows of them.
  std::vector<std::int16_t> rows[2], least[2];
  for (int i = 0; i < 2; ++i) {
    rows[i].assign(std::size_t(3) * (width_ + 2) * pitch, sgm::kFar);
    least[i].assign(std::size_t(3) * (width_ + 2), 0);
  }
  std::vector<std::int16_t> along(2 * std::size_t(pitch), sgm::kFar);
  const std::vector<std::int16_t> nothing(pitch, sgm::kFar);
  for (int n = 0; n < height_; ++n) {
    const int y = down > 0 ? n : height_ - 1 - n;
    const auto &before = rows[n % 2], &least_before = least[n % 2];
    auto &now = rows[1 - n % 2], &least_now = least[1 - n % 2];
    std::int16_t least_along = 0;
    for (int m = 0; m < width_; ++m) {
      const int x = down > 0 ? m : width_ - 1 - m;
      const auto largeStep = [&](int from_x, int from_y) {
        const float edge = std::abs(left_.at<float>(y, x) - left_.at<float>(from_y, from_x)) / kEdge_grey;
        return std::int16_t(
            std::max(kLeastLargeStep, int(float(kLargeStep) / (1.0f + (edge > 0 ? edge : 0.0f)))));
      };
      const std::uint8_t* cost = costs_.data() + at(x, y);
      std::int16_t* total = totals_.data() + at(x, y);
      // A path that begins here has no earlier costs; its `jump` is 0.
      const auto walk = [&](const std::int16_t* from, std::int16_t least_from, bool is_first, int dx, int dy,
                            std::int16_t* to) {
        if (is_first)
          return step(cost, nothing.data() + sgm::kPadding, 0, 0, 0, disparities_, to + sgm::kPadding, total);
        return step(cost, from + sgm::kPadding, least_from, kSmallStep, largeStep(x - dx, y - dy),
                    disparities_, to + sgm::kPadding, total);
      };
      std::int16_t *last = along.data() + (m % 2) * pitch, *next = along.data() + (1 - m % 2) * pitch;
      least_along = walk(last, least_along, m == 0, down, 0, next);
      for (int k = 0; k < 3; ++k) {
        const int dx = k - 1, from_x = x - dx;
        const bool is_first = n == 0 || from_x < 0 || from_x >= width_;
        const std::size_t from = std::size_t(k) * (width_ + 2) + from_x + 1,
                          to = std::size_t(k) * (width_ + 2) + x + 1;
        least_now[to] = walk(before.data() + from * pitch, least_before[from], is_first, dx, down,
                             now.data() + to * pitch);
      }
    }
  }
}

struct Winner {
  int disparity = -1;
  float fraction = 0;
};

Winner winnerOf(const std::int16_t* totals, int disparities) {
  const int best = int(std::min_element(totals, totals + disparities) - totals);
  Winner winner{best, 0};
  if (best > 0 && best + 1 < disparities) {
    const int before = totals[best - 1], after = totals[best + 1];
    const int rise = std::max(before, after) - totals[best];
    if (rise > 0) winner.fraction = 0.5f * float(before - after) / float(rise);  // costs are V-shaped
  }
  return winner;
}

// Left-right consistent disparities of a row; NaN elsewhere.
void matchRow(const Volume& volume, const Rectification& r, int y, cv::Mat& disparity) {
  const int width = disparity.cols, columns = width + r.disparities;
  std::vector<int> best_cost(columns, std::numeric_limits<int>::max()), best(columns, -1);
  for (int x = 0; x < width; ++x) {
    const std::int16_t* totals = volume.totals(x, y);
    for (int d = 0; d < r.disparities; ++d) {
      const int column = x - d + r.disparities;
      if (column >= columns || totals[d] >= best_cost[column]) continue;
      best_cost[column] = totals[d];
      best[column] = d;
    }
  }
  for (int x = 0; x < width; ++x) {
    const Winner winner = winnerOf(volume.totals(x, y), r.disparities);
    const int column = x - winner.disparity + r.disparities;
    const bool is_good = r.left_mask.at<std::uint8_t>(y, x) && column >= 0 && column < columns &&
                         r.right_mask.at<std::uint8_t>(y, column) &&
                         std::abs(best[column] - winner.disparity) <= 1;
    disparity.at<float>(y, x) = is_good ? float(winner.disparity) + winner.fraction : kNone;
  }
}

// Fills holes with the background beside them: the smaller disparity of the nearest matches along the row.
cv::Mat filledAlongRows(const cv::Mat& disparity, const cv::Mat& mask) {
  cv::Mat filled = disparity.clone();
  for (int y = 0; y < filled.rows; ++y) {
    std::vector<float> left(filled.cols, kNone), right(filled.cols, kNone);
    float last = kNone;
    for (int x = 0; x < filled.cols; ++x) {
      const float d = disparity.at<float>(y, x);
      left[x] = last = std::isnan(d) ? last : d;
    }
    last = kNone;
    for (int x = filled.cols - 1; x >= 0; --x) {
      const float d = disparity.at<float>(y, x);
      right[x] = last = std::isnan(d) ? last : d;
    }
    for (int x = 0; x < filled.cols; ++x)
      if (std::isnan(filled.at<float>(y, x)) && mask.at<std::uint8_t>(y, x))
        filled.at<float>(y, x) =
            std::isnan(left[x]) ? right[x] : (std::isnan(right[x]) ? left[x] : std::min(left[x], right[x]));
  }
  return filled;
}

class SgmMatcher : public DenseMatcher {
 public:
  DisparityMap match(const Rectification& rectification, const RectifiedPair& pair,
                     const MatchOptions& options) const override {
    const Volume volume(rectification, pair);
    cv::Mat found(pair.left.size(), CV_32F);
    parallelRanges(0, found.rows, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) matchRow(volume, rectification, y, found);
    });
    constexpr float kLargestStep_px = 1.5f;
    removeSpeckles(found, options.smallest_patch_px, kLargestStep_px);
    DisparityMap map;
    map.sigma_px = cv::Mat(found.size(), CV_32F, cv::Scalar(kMeasured_px));
    map.sigma_px.setTo(kFilled_px, found != found);  // NaN differs from itself
    map.disparity_px = filledAlongRows(found, rectification.left_mask);
    cv::Mat smooth;
    cv::medianBlur(map.disparity_px, smooth, 5);
    smooth.copyTo(map.disparity_px, smooth == smooth);
    map.disparity_px.setTo(kNone, map.sigma_px > options.largest_sigma_px);
    return map;
  }
};

}  // namespace

std::unique_ptr<DenseMatcher> makeSgmMatcher() { return std::make_unique<SgmMatcher>(); }

}  // namespace facenav::stereo
