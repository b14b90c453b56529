#include "skin_evenness.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"

namespace facenav::health {
namespace {

constexpr double kTogether_px = 25.0;  // about the width of one window of growMatches

}  // namespace

double sharedResidual(const Eigen::Isometry3d& right_T_left, const std::vector<RayPair>& rays,
                      const std::vector<Eigen::Vector2d>& left_px, double most) {
  std::vector<double> residual;
  for (const RayPair& pair : rays) residual.push_back(signedEpipolarDistance(right_T_left, pair));
  double squares = 0;
  for (const auto& at : left_px) {
    std::vector<double> around;
    for (std::size_t k = 0; k < rays.size(); ++k)
      if ((left_px[k] - at).squaredNorm() < kTogether_px * kTogether_px) around.push_back(residual[k]);
    squares += std::pow(std::min(most, std::abs(upperMedian(std::move(around)))), 2);
  }
  return std::sqrt(squares / double(std::max<std::size_t>(1, rays.size())));
}

}  // namespace facenav::health
