#include "epipolar_check.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace facenav::stereo {
namespace {

constexpr int kHalf_px = 7, kStep_px = 6;
constexpr std::size_t kFewest = 30;

// Least squares for the row shift (with disparity, gain and offset free) of the right window at its matched
// place.
std::optional<double> rowDifference(const RectifiedPair& pair, const Rectification& r, int x, int y,
                                    float disparity, float slope_x, float slope_y) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d rhs = Eigen::Vector4d::Zero();
  for (int v = -kHalf_px; v <= kHalf_px; ++v)
    for (int u = -kHalf_px; u <= kHalf_px; ++u) {
      const float at =
          (float(x + u + r.disparities) - disparity - slope_x * float(u) - slope_y * float(v)) * kFineSteps;
      const int i = int(at);
      if (at < 0 || i + 1 >= pair.right_fine.cols) return std::nullopt;
      const float f = at - float(i);
      const auto right = [&](int row) {
        const float* p = pair.right_fine.ptr<float>(row);
        return p[i] + f * (p[i + 1] - p[i]);
      };
      const float* p = pair.right_fine.ptr<float>(y + v);
      const Eigen::Vector4d j(0.5 * (right(y + v + 1) - right(y + v - 1)), kFineSteps * (p[i + 1] - p[i]),
                              right(y + v), 1);
      normal += j * j.transpose();
      rhs += j * double(pair.left.at<float>(y + v, x + u));
    }
  const Eigen::Vector4d solution = normal.ldlt().solve(rhs);
  if (!solution.allFinite() || std::abs(solution[2]) < 0.2) return std::nullopt;
  return solution[0] / solution[2];
}

}  // namespace

double epipolarMedian(const Rectification& rectification, const RectifiedPair& pair,
                      const DisparityMap& map) {
  std::vector<double> differences_px;
  const int margin = kHalf_px + 1;
  for (int y = margin; y < pair.left.rows - margin; y += kStep_px)
    for (int x = margin; x < pair.left.cols - margin; x += kStep_px) {
      const float d = map.disparity_px.at<float>(y, x);
      if (std::isnan(d)) continue;
      const bool has_slopes = !map.slope_x.empty();
      const auto difference =
          rowDifference(pair, rectification, x, y, d, has_slopes ? map.slope_x.at<float>(y, x) : 0,
                        has_slopes ? map.slope_y.at<float>(y, x) : 0);
      if (difference) differences_px.push_back(std::abs(*difference));
    }
  if (differences_px.size() < kFewest) return 0;
  const auto middle = differences_px.begin() + std::ptrdiff_t(differences_px.size() / 2);
  std::nth_element(differences_px.begin(), middle, differences_px.end());
  return *middle;
}

}  // namespace facenav::stereo
