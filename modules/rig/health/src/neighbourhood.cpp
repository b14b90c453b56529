#include "neighbourhood.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace facenav::health {
std::vector<std::size_t> nearest(const std::vector<PixelPair>& pairs, const Eigen::Vector2d& left_px,
                                 std::size_t count, double reach_px) {
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double d2 = (pairs[i].left_px - left_px).squaredNorm();
    if (d2 < reach_px * reach_px) by_distance.emplace_back(d2, i);
  }
  count = std::min(count, by_distance.size());
  std::partial_sort(by_distance.begin(), by_distance.begin() + std::ptrdiff_t(count), by_distance.end());
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < count; ++k) found.push_back(by_distance[k].second);
  return found;
}

std::optional<Neighbourhood> neighbourhood(const std::vector<PixelPair>& seeds,
                                           const Eigen::Vector2d& left_px,
                                           const NeighbourhoodOptions& options) {
  const auto around = nearest(seeds, left_px, options.most, options.reach_px);
  if (around.size() < options.fewest) return std::nullopt;
  const double tilt = options.untilted_px * options.untilted_px;
  Eigen::Matrix3d normal = Eigen::Vector3d(1e-6, tilt, tilt).asDiagonal();
  Eigen::Matrix<double, 3, 2> rhs = Eigen::Matrix<double, 3, 2>::Zero();
  for (const std::size_t i : around) {
    const Eigen::Vector2d away = seeds[i].left_px - left_px;
    const Eigen::Vector3d design(1, away.x(), away.y());
    const double weight = 1.0 / (1.0 + away.squaredNorm() / (options.falloff_px * options.falloff_px));
    normal += weight * design * design.transpose();
    rhs += weight * design * seeds[i].shift().transpose();
  }
  const Eigen::Matrix<double, 3, 2> solution = normal.ldlt().solve(rhs);
  Neighbourhood here{left_px + solution.row(0).transpose(),
                     Eigen::Matrix2d::Identity() + solution.bottomRows<2>().transpose()};
  const double area = here.map.determinant();
  if (!(area > 0.3 && area < 3.0)) return std::nullopt;
  return here;
}

cv::Mat warped(const cv::Mat& image, const Eigen::Vector2d& at_px, const Eigen::Matrix2d& map, int side_px) {
  const double middle = 0.5 * (side_px - 1);
  const Eigen::Vector2d offset = at_px - map * Eigen::Vector2d(middle, middle);
  const cv::Matx23d affine(map(0, 0), map(0, 1), offset.x(), map(1, 0), map(1, 1), offset.y());
  cv::Mat out;
  cv::warpAffine(image, out, affine, {side_px, side_px}, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                 cv::BORDER_REPLICATE);
  return out;
}

}  // namespace facenav::health
