#include "prior/stated_doubt.h"

#include <algorithm>
#include <array>

#include "facenav/core/robust_statistics.h"
#include "facenav/volume/mask_morphology.h"

namespace facenav::segmentation {
namespace {

// Model and maps were fitted on painted heads that the network never saw (evidence:
// resources/doc/evidence.md). FLAIR uses the map of proton density: a map of its own did worse on held-out
// heads. Larger doubts are the safe direction.
constexpr float kPriorWidth = 0.054f, kMoved = 0.031f, kFitWidth = 0.151f;  // least squares, none below 0
constexpr float kMostFitWidth_mm = 20;
constexpr float kOfScan = 0.75f;  // share of a scan's own level of scores that is subtracted
constexpr float kLeastStated_mm = 0.2f;
constexpr std::array<float, 5> kStated_mm{1, 2, 3, 5, 8};

struct DoubtMap {
  float usual;                  // median over scans of a scan's median score
  std::array<float, 5> scores;  // scores at kStated_mm
};
constexpr DoubtMap kLikeT1{0.519f, {0.707f, 1.041f, 1.358f, 1.602f, 2.036f}};
constexpr DoubtMap kLikeWeakT1{0.519f, {0.634f, 0.868f, 1.144f, 1.462f, 1.718f}};
constexpr DoubtMap kLikeT2{0.516f, {0.681f, 0.929f, 1.217f, 1.588f, 1.732f}};
constexpr DoubtMap kLikeDensity{0.633f, {0.751f, 1.007f, 1.357f, 1.984f, 2.744f}};

const DoubtMap& mapOf(ContrastKind kind) {
  switch (kind) {
    case ContrastKind::t1:
      return kLikeT1;
    case ContrastKind::weak_t1:
      return kLikeWeakT1;
    case ContrastKind::t2:
      return kLikeT2;
    case ContrastKind::flair:
    case ContrastKind::proton_density:
      break;
  }
  return kLikeDensity;
}

/// Interpolates linearly between the map's places, and from the first one down to 0 at score 0.
float stated_mm(float score, const DoubtMap& map) {
  if (score < map.scores[0]) return std::max(kLeastStated_mm, kStated_mm[0] * score / map.scores[0]);
  std::size_t above = 1;
  while (above + 1 < map.scores.size() && score > map.scores[above]) ++above;
  const float low = map.scores[above - 1], share = (score - low) / (map.scores[above] - low);
  const float at_mm = kStated_mm[above - 1] + share * (kStated_mm[above] - kStated_mm[above - 1]);
  return std::min(at_mm, kStated_mm.back());
}

}  // namespace

float doubtScore(const PlaceEvidence& evidence) {
  return kPriorWidth * evidence.prior_width_mm + kMoved * evidence.moved_mm +
         kFitWidth * std::min(evidence.fit_width_mm, kMostFitWidth_mm);
}

void stateDoubts(std::vector<BoundaryDoubt>& scores, ContrastKind kind) {
  if (scores.empty()) return;
  const DoubtMap& map = mapOf(kind);
  std::vector<float> all;
  for (const auto& place : scores) all.push_back(place.doubt_mm);
  const float shift = kOfScan * (upperMedian(std::move(all)) - map.usual);
  for (auto& place : scores) place.doubt_mm = stated_mm(place.doubt_mm - shift, map);
}

void raiseDoubts(std::vector<BoundaryDoubt>& doubts, const volume::Mask& other) {
  const auto& grid = other.grid;
  const std::vector<float> away_mm = volume::distanceTo(volume::surfaceVoxels(other));
  const Eigen::Vector3d last(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  for (auto& doubt : doubts) {
    const Eigen::Vector3d within = grid.toVoxel(doubt.place).cwiseMax(0).cwiseMin(last);
    const float beyond_mm = float((doubt.place.mm - grid.toMri(within).mm).norm());
    const Eigen::Vector3i at = within.array().round().cast<int>();
    const float there_mm = away_mm[grid.index(at.x(), at.y(), at.z())];
    doubt.doubt_mm = std::max({doubt.doubt_mm, beyond_mm, there_mm - beyond_mm});
  }
}

}  // namespace facenav::segmentation
