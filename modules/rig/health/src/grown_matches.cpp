#include <Eigen/Cholesky>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "facenav/geometry/normal_equations.h"
#include "facenav/health/pair_matches.h"
#include "neighbourhood.h"

namespace facenav::health {
namespace {

constexpr int kHalf_px = 14, kReach_px = 5;  // of a window (5 mm of skin at 2.7 px/mm), and of its search
constexpr int kStep_px = 10, kMargin_px = kHalf_px + kReach_px + 2;
constexpr double kNearSeed_px = 23;  // a window is tried when two matches are this near
constexpr int kFewestNear = 2, kMostTries = 3;
// Grown matches lie closer together than corners and are less exact: more neighbours, within a smaller
// radius.
constexpr NeighbourhoodOptions kSeedsAround{12, 4, 60, 10, 30};
constexpr double kLeastCorrelation = 0.9, kMostSigma_px = 0.5;
// Neighbouring pixels of a window have common errors: blur of the lens, blocks of the compression.
constexpr double kSharedError = 2.0;

/// Finds `wanted` in `seen` (both 32-bit float) by least squares, gain and offset free, from `at` (of its
/// first column and row). Changes `at`; returns its standard error, px.
std::optional<double> refine(const cv::Mat& wanted, const cv::Mat& seen, Eigen::Vector2d& at) {
  const int side = wanted.cols;
  const Eigen::Vector2d start = at;
  double sigma_px = 0;
  for (int round = 0; round < 6; ++round) {
    cv::Mat now;
    cv::getRectSubPix(seen, {side + 2, side + 2},
                      cv::Point2f(float(at.x() + kHalf_px), float(at.y() + kHalf_px)), now);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d rhs = Eigen::Vector4d::Zero();
    double squares = 0;
    for (int y = 0; y < side; ++y) {
      const float *above = now.ptr<float>(y) + 1, *row = now.ptr<float>(y + 1) + 1,
                  *below = now.ptr<float>(y + 2) + 1, *grey = wanted.ptr<float>(y);
      for (int x = 0; x < side; ++x) {
        const Eigen::Vector4d j(0.5 * (row[x + 1] - row[x - 1]), 0.5 * (below[x] - above[x]), row[x], 1);
        normal.noalias() += j * j.transpose();
        rhs += j * double(grey[x]);
        squares += double(grey[x]) * grey[x];
      }
    }
    const Eigen::Vector4d solution = solveSymmetric(normal, rhs);
    const Eigen::Vector2d step = solution.head<2>() / solution[2];
    if (!step.allFinite() || step.norm() > 2) return std::nullopt;
    at += step;
    const double residual2 = std::max(0.0, squares - solution.dot(rhs)) / (side * side);
    const Eigen::Matrix4d inverse = inverseOfSymmetric(normal);
    sigma_px = kSharedError * std::sqrt(residual2 * inverse.topLeftCorner<2, 2>().trace());
    if (step.norm() < 0.01) break;
  }
  if ((at - start).norm() > 2) return std::nullopt;
  return sigma_px;
}

std::optional<Correspondence> matchWindow(const cv::Mat& left, const cv::Mat& right, const cv::Point& at,
                                          const Neighbourhood& here) {
  const int side = 2 * kHalf_px + 1;
  const cv::Mat window = left(cv::Rect(at.x - kHalf_px, at.y - kHalf_px, side, side));
  const cv::Mat seen = warped(right, here.at, here.map, side + 2 * kReach_px);
  cv::Mat alike, wanted_grey, seen_grey;
  cv::matchTemplate(seen, window, alike, cv::TM_CCOEFF_NORMED);
  double most = 0;
  cv::Point best;
  cv::minMaxLoc(alike, nullptr, &most, nullptr, &best);
  const bool is_at_border = best.x == 0 || best.y == 0 || best.x == 2 * kReach_px || best.y == 2 * kReach_px;
  if (is_at_border || most < kLeastCorrelation) return std::nullopt;
  window.convertTo(wanted_grey, CV_32F);
  seen.convertTo(seen_grey, CV_32F);
  Eigen::Vector2d place(best.x, best.y);
  const auto sigma_px = refine(wanted_grey, seen_grey, place);
  if (!sigma_px || *sigma_px > kMostSigma_px) return std::nullopt;
  const Eigen::Vector2d middle = Eigen::Vector2d::Constant(kReach_px);
  return Correspondence{{at.x, at.y}, here.at + here.map * (place - middle), *sigma_px};
}

class Growth {
 public:
  Growth(const cv::Mat& left, const cv::Mat& right, const std::vector<Correspondence>& seeds)
      : left_(left),
        right_(right),
        near_(left.rows / kStep_px + 1, left.cols / kStep_px + 1, 0),
        tries_(near_.size(), 0) {
    for (const auto& seed : seeds) know(seed);
  }

  /// Adds one more ring around the known matches; false if there is nothing to add.
  bool grow() {
    std::vector<Correspondence> fresh;
    for (int v = 0; v < near_.rows; ++v)
      for (int u = 0; u < near_.cols; ++u)
        if (const auto match = tryAt(u, v)) fresh.push_back(*match);
    for (const auto& match : fresh) know(match);
    found.insert(found.end(), fresh.begin(), fresh.end());
    return !fresh.empty();
  }

  std::vector<Correspondence> found;

 private:
  std::optional<Correspondence> tryAt(int u, int v) {
    const cv::Point at(u * kStep_px, v * kStep_px);
    const cv::Rect inner(kMargin_px, kMargin_px, left_.cols - 2 * kMargin_px, left_.rows - 2 * kMargin_px);
    int& tries = tries_(v, u);
    if (tries >= kMostTries || near_(v, u) < kFewestNear || !inner.contains(at)) return std::nullopt;
    ++tries;
    const auto here = neighbourhood(known_, {at.x, at.y}, kSeedsAround);
    const auto match = here ? matchWindow(left_, right_, at, *here) : std::nullopt;
    if (match) tries = kMostTries;
    return match;
  }

  void know(const Correspondence& match) {
    known_.push_back({match.left_px, match.right_px});
    const Eigen::Vector2d at = match.left_px / kStep_px;
    const int reach = int(kNearSeed_px / kStep_px) + 1;
    for (int v = std::max(0, int(at.y()) - reach); v <= std::min(near_.rows - 1, int(at.y()) + reach + 1);
         ++v)
      for (int u = std::max(0, int(at.x()) - reach); u <= std::min(near_.cols - 1, int(at.x()) + reach + 1);
           ++u)
        near_(v, u) += kStep_px * (Eigen::Vector2d(u, v) - at).norm() < kNearSeed_px;
  }

  cv::Mat left_, right_;
  cv::Mat_<int> near_;   // known matches near each window
  cv::Mat_<int> tries_;  // tries of each window
  std::vector<PixelPair> known_;
};

}  // namespace

std::vector<Correspondence> growMatches(const cv::Mat& left, const cv::Mat& right,
                                        const std::vector<Correspondence>& seeds) {
  Growth growth(left, right, seeds);
  while (growth.grow()) {
  }
  return growth.found;
}

}  // namespace facenav::health
