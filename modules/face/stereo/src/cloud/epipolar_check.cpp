#include "epipolar_check.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <vector>

#include "facenav/core/robust_statistics.h"
#include "facenav/geometry/normal_equations.h"
#include "matchers/block_search.h"

namespace facenav::stereo {
namespace {

constexpr int kHalf_px = 7, kLeastStep_px = 6, kMostWindows = 400;  // the median of so many is exact enough
constexpr std::size_t kFewestDifferences = 30;

// Grey level between the pixels of a row (cubic convolution), 1 <= x < columns - 2.
inline double betweenPixels(const float* row, double x) {
  const int i = int(x);
  const double t = x - i, a = row[i - 1], b = row[i], c = row[i + 1], d = row[i + 2];
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

// Sums of one least-squares step; unknowns: row shift, disparity, gain and offset.
struct RowFit {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d rhs = Eigen::Vector4d::Zero();
  double squares = 0;  // sum of squares of the left grey values
};

// True if the window determines its row shift. The gradient across the rows that the other unknowns do not
// explain must exceed that of noise, which is at most half the residual for independent noise in both images
// (differences of rows: variance 1/2 of an image's, residuals: 2). Without texture the least squares would
// return 0, which is no measurement.
bool fixesRowShift(const RowFit& fit, const Eigen::Vector4d& solution) {
  constexpr double kLeastGradient_grey = 0.05, kNoiseGradient = 0.65;
  constexpr double kPixels = (2 * kHalf_px + 1) * (2 * kHalf_px + 1);
  const Eigen::Vector3d mixed = fit.normal.block<3, 1>(1, 0);
  const Eigen::Vector3d explained =
      fit.normal.bottomRightCorner<3, 3>().completeOrthogonalDecomposition().solve(mixed);
  const double gradient = std::sqrt(std::max(0.0, fit.normal(0, 0) - mixed.dot(explained)) / kPixels);
  const double residual = std::sqrt(std::max(0.0, fit.squares - solution.dot(fit.rhs)) / kPixels);
  return gradient > std::max(kLeastGradient_grey, kNoiseGradient * residual);
}

// Two least-squares steps for the row shift of the right window at its matched place. Returns nothing if the
// window does not determine it.
std::optional<double> rowDifference(const RectifiedPair& pair, const Rectification& r, int x, int y,
                                    float disparity, float slope_x, float slope_y) {
  double shift = 0, along = 0;
  for (int step = 0; step < 2; ++step) {
    RowFit sums;
    const int whole = int(std::floor(shift));
    const double part = shift - whole;
    if (y - kHalf_px - 1 + whole < 0 || y + kHalf_px + 2 + whole >= pair.right.rows) return std::nullopt;
    for (int v = -kHalf_px; v <= kHalf_px; ++v)
      for (int u = -kHalf_px; u <= kHalf_px; ++u) {
        const double at = double(x + u + r.disparities) - disparity - slope_x * u - slope_y * v + along;
        if (!(at >= 2 && at < pair.right.cols - 3)) return std::nullopt;
        const auto in_row = [&](int row) { return betweenPixels(pair.right.ptr<float>(row + whole), at); };
        const auto right = [&](int row) { return in_row(row) * (1 - part) + in_row(row + 1) * part; };
        const float* p = pair.right.ptr<float>(y + v + whole);
        const Eigen::Vector4d j(0.5 * (right(y + v + 1) - right(y + v - 1)),
                                2.0 * (betweenPixels(p, at + 0.25) - betweenPixels(p, at - 0.25)),
                                right(y + v), 1);
        const double left = double(pair.left.at<float>(y + v, x + u));
        sums.normal += j * j.transpose();
        sums.rhs += j * left;
        sums.squares += left * left;
      }
    const Eigen::Vector4d solution = solveSymmetric(sums.normal, sums.rhs);
    if (!solution.allFinite() || std::abs(solution[2]) < 0.2) return std::nullopt;
    if (step == 1 && !fixesRowShift(sums, solution)) return std::nullopt;
    shift += std::clamp(solution[0] / solution[2], -1.0, 1.0);
    along += std::clamp(solution[1] / solution[2], -1.0, 1.0);
  }
  return shift;
}

}  // namespace

std::optional<double> epipolarMedian(const Rectification& rectification, const RectifiedPair& pair,
                                     const DisparityMap& map) {
  std::vector<double> differences_px;
  const int margin = kHalf_px + 1;
  const int matched = cv::countNonZero(map.disparity_px == map.disparity_px);  // NaN differs from itself
  const int step_px = std::max(kLeastStep_px, int(std::sqrt(double(matched) / kMostWindows)));
  for (int y = margin; y < pair.left.rows - margin; y += step_px)
    for (int x = margin; x < pair.left.cols - margin; x += step_px) {
      const float d = map.disparity_px.at<float>(y, x);
      if (std::isnan(d)) continue;
      const bool has_slopes = !map.slope_x.empty();
      const auto difference =
          rowDifference(pair, rectification, x, y, d, has_slopes ? map.slope_x.at<float>(y, x) : 0,
                        has_slopes ? map.slope_y.at<float>(y, x) : 0);
      if (difference) differences_px.push_back(std::abs(*difference));
    }
  if (differences_px.size() < kFewestDifferences) return std::nullopt;
  return upperMedian(std::move(differences_px));
}

double bestRowShift(const cameras::StereoRig& rig, const cameras::StereoFrame& frame,
                    const FaceCloudOptions& options) {
  const Rectification rectification =
      rectify(rig, {options.nearest_mm, options.farthest_mm}, options.left_roi.value_or(cv::Rect()));
  const RectifiedPair pair = applyRectification(rectification, frame);
  const auto matched = [&](int rows) {
    const cv::Mat by = (cv::Mat_<double>(2, 3) << 1, 0, 0, 0, 1, rows);
    RectifiedPair shifted = pair;
    shifted.right.release();  // not in place, because the buffer is shared
    cv::warpAffine(pair.right, shifted.right, by, pair.right.size(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
    return matchedBlocks(rectification, shifted);
  };
  constexpr int kFarthest_rows = 10;
  const int unshifted = matched(0);
  int best = 0, most = std::max(2 * unshifted, int(pair.left.total() / 16 / 50));
  for (int rows = -kFarthest_rows; rows <= kFarthest_rows; ++rows) {
    const int count = matched(rows);
    if (count > most) {
      most = count;
      best = rows;
    }
  }
  return best;
}

}  // namespace facenav::stereo
