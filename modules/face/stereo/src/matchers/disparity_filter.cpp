#include "disparity_filter.h"

#include <cmath>
#include <limits>
#include <vector>

namespace facenav::stereo {
namespace {

// Flood fill from `start`; marks and returns the patch's pixel indices.
std::vector<int> patchFrom(int start, const cv::Mat& disparity, float largest_step_px,
                           std::vector<char>& is_seen) {
  const float* d = disparity.ptr<float>();
  const int cols = disparity.cols, count = int(disparity.total());
  std::vector<int> patch{start};
  is_seen[start] = 1;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const int at = patch[i], x = at % cols;
    const auto visit = [&](int next) {
      if (is_seen[next] || !(std::abs(d[next] - d[at]) <= largest_step_px)) return;
      is_seen[next] = 1;
      patch.push_back(next);
    };
    if (x > 0) visit(at - 1);
    if (x + 1 < cols) visit(at + 1);
    if (at >= cols) visit(at - cols);
    if (at + cols < count) visit(at + cols);
  }
  return patch;
}

}  // namespace

void removeSpeckles(cv::Mat& disparity, int smallest, float largest_step_px) {
  float* d = disparity.ptr<float>();
  std::vector<char> is_seen(disparity.total(), 0);
  for (int i = 0; i < int(is_seen.size()); ++i) {
    if (is_seen[i] || std::isnan(d[i])) continue;
    const auto patch = patchFrom(i, disparity, largest_step_px, is_seen);
    if (int(patch.size()) >= smallest) continue;
    for (const int at : patch) d[at] = std::numeric_limits<float>::quiet_NaN();
  }
}

DisparityMap withoutSpeckles(DisparityMap map, int smallest_patch_px) {
  constexpr float kLargestStep_px = 1.0f;
  removeSpeckles(map.disparity_px, smallest_patch_px, kLargestStep_px);
  return map;
}

}  // namespace facenav::stereo
