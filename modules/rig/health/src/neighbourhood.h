#pragma once
// Affine map of the surroundings of a place from the left picture to the right one, fitted to matches near
// it. A patch is warped by it before it is compared.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace facenav::health {

struct PixelPair {
  Eigen::Vector2d left_px, right_px;
  Eigen::Vector2d shift() const { return right_px - left_px; }
};

/// Map right = at + map * (left - origin), from the seeds about a place.
struct Neighbourhood {
  Eigen::Vector2d at;
  Eigen::Matrix2d map;
};

/// Indices of the `count` pairs nearest to `left_px`, nearest first, none farther than `reach_px`.
std::vector<std::size_t> nearest(const std::vector<PixelPair>& pairs, const Eigen::Vector2d& left_px,
                                 std::size_t count, double reach_px);

struct NeighbourhoodOptions {
  std::size_t most = 8, fewest = 3;  // number of seeds
  double reach_px = 80;
  double untilted_px = 15;  // prior of the affine map: seeds this far off hardly determine it
  double falloff_px = 20;   // distance at which a seed has half its weight
};

/// Fits the map to the nearest seeds. nullopt if there are too few, or if they contradict each other.
std::optional<Neighbourhood> neighbourhood(const std::vector<PixelPair>& seeds,
                                           const Eigen::Vector2d& left_px,
                                           const NeighbourhoodOptions& options = {});

/// The part of `image` about a place, as the other camera sees it: pixel u of side_px x side_px shows at_px +
/// map * (u - middle).
cv::Mat warped(const cv::Mat& image, const Eigen::Vector2d& at_px, const Eigen::Matrix2d& map, int side_px);

}  // namespace facenav::health
