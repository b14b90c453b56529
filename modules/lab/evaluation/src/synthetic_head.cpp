#include "facenav/evaluation/synthetic_head.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "facenav/core/error.h"
#include "facenav/evaluation/volume_perturbation.h"
#include "facenav/geometry/rotation.h"
#include "facenav/volume/smoothing.h"

namespace facenav::evaluation {
namespace {

using volume::Volume;
using volume::VoxelGrid;
using Random = std::mt19937;

constexpr double kLeastWave_mm = 70, kMostWave_mm = 160;  // of the bending
constexpr double kMostValue = 255, kMostAir = 15;         // of any contrast
constexpr double kLeastSpread = 3, kMostSpread = 25;
// Labels used in place of labels without statistics: cortex inside the skull, soft tissue outside.
constexpr int kLikeInside = 3, kLikeOutside = 509, kOutsideOfSkull = 500;

double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// amount * sin * sin * sin of the three voxel indices: smooth, and stored in three short tables.
class Wave {
 public:
  Wave(Random& random, const VoxelGrid& grid, double most_mm) : amount_(between(random, -most_mm, most_mm)) {
    for (int a = 0; a < 3; ++a) {
      const double wave = between(random, kLeastWave_mm, kMostWave_mm), phase = between(random, 0, 2 * M_PI);
      for (int i = 0; i < grid.size[a]; ++i)
        values_[a].push_back(std::sin(2 * M_PI * i * grid.spacing_mm()[a] / wave + phase));
    }
  }
  double at(int i, int j, int k) const { return amount_ * values_[0][i] * values_[1][j] * values_[2][k]; }

 private:
  double amount_;
  std::array<std::vector<double>, 3> values_;
};

/// Rotation and size, about the grid's centre, in voxels.
Eigen::Affine3d movedVoxels(Random& random, const VoxelGrid& grid, const SyntheticRanges& ranges) {
  const double deg = kRadPerDeg * ranges.turn_deg;
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity() / between(random, ranges.least_size, ranges.most_size);
  for (int a = 0; a < 3; ++a)
    linear =
        linear * Eigen::AngleAxisd(between(random, -deg, deg), Eigen::Vector3d::Unit(a)).toRotationMatrix();
  const Eigen::Vector3d centre = grid.toVoxel(grid.centre());
  return Eigen::Translation3d(centre) * Eigen::Affine3d(linear) * Eigen::Translation3d(-centre);
}

/// Nearest label at the moved and bent place; background beyond the grid.
std::vector<std::uint16_t> deformedLabels(const LabelledHead& head, Random& random,
                                          const SyntheticRanges& ranges) {
  const Eigen::Affine3d move = movedVoxels(random, head.grid, ranges);
  const Eigen::Vector3d spacing = head.grid.spacing_mm();
  const std::array<Wave, 3> bend{Wave(random, head.grid, ranges.bend_mm),
                                 Wave(random, head.grid, ranges.bend_mm),
                                 Wave(random, head.grid, ranges.bend_mm)};
  std::vector<std::uint16_t> labels(head.labels.size());
  std::size_t v = 0;
  for (int k = 0; k < head.grid.size[2]; ++k)
    for (int j = 0; j < head.grid.size[1]; ++j)
      for (int i = 0; i < head.grid.size[0]; ++i, ++v) {
        Eigen::Vector3d p = move * Eigen::Vector3d(i, j, k);
        for (int a = 0; a < 3; ++a) p[a] += bend[a].at(i, j, k) / spacing[a];
        const Eigen::Vector3i at = p.array().round().cast<int>();
        if (head.grid.contains(at.x(), at.y(), at.z()))
          labels[v] = head.labels[head.grid.index(at.x(), at.y(), at.z())];
      }
  return labels;
}

struct Paint {
  double mean = 0, deviation = 0;
};

Paint drawT1(Random& random, const LabelStatistics& s) {
  std::normal_distribution<double> normal;
  const double mean = s.mean_of_means + s.deviation_of_means * normal(random);
  return {std::max(0.0, mean),
          std::max(1.0, s.mean_of_deviations + s.deviation_of_deviations * normal(random))};
}

Paint drawAny(Random& random, bool is_air) {
  if (is_air) return {between(random, 0, kMostAir), kLeastSpread};
  const double mean = between(random, 0, kMostValue);
  return {mean, between(random, kLeastSpread, kMostSpread)};
}

/// Draws one paint a class; returns them by label.
std::vector<Paint> drawPaints(const std::map<int, LabelStatistics>& statistics, SyntheticContrast contrast,
                              Random& random) {
  const auto air = statistics.find(0);
  if (air == statistics.end()) throw Error("the label statistics lack the background", "label 0");
  std::map<int, Paint> by_class;
  for (const auto& [label, s] : statistics)
    if (!by_class.count(s.tissue_class))
      by_class[s.tissue_class] = contrast == SyntheticContrast::t1
                                     ? drawT1(random, s)
                                     : drawAny(random, s.tissue_class == air->second.tissue_class);
  std::vector<Paint> paints(65536);
  for (int label = 0; label < int(paints.size()); ++label) {
    auto known = statistics.find(label);
    if (known == statistics.end())
      known = statistics.find(label < kOutsideOfSkull ? kLikeInside : kLikeOutside);
    if (known == statistics.end()) known = air;
    paints[label] = by_class[known->second.tissue_class];
  }
  return paints;
}

}  // namespace

SyntheticHead makeSyntheticHead(const LabelledHead& head, const std::map<int, LabelStatistics>& statistics,
                                SyntheticContrast contrast, unsigned seed, const SyntheticRanges& ranges) {
  Random random(seed);
  const auto labels = deformedLabels(head, random, ranges);
  const auto paints = drawPaints(statistics, contrast, random);
  std::normal_distribution<float> normal;
  SyntheticHead made{{head.grid, std::vector<float>(labels.size()), "MR", "sform"},
                     {head.grid, std::vector<std::uint8_t>(labels.size())}};
  for (std::size_t v = 0; v < labels.size(); ++v) {
    const Paint& paint = paints[labels[v]];
    made.scan.voxels[v] = std::max(0.f, float(paint.mean) + float(paint.deviation) * normal(random));
    made.tissue.voxels[v] = isBrainTissue(labels[v]);
  }
  Eigen::Vector3d blur;
  for (int a = 0; a < 3; ++a) blur[a] = between(random, ranges.least_blur_mm2, ranges.most_blur_mm2);
  const Eigen::Vector3d spacing = head.grid.spacing_mm();
  made.scan = volume::spread(made.scan, blur.cwiseQuotient(spacing.cwiseProduct(spacing)).cwiseMin(0.5));
  VolumePerturbation scanner;
  scanner.bias = between(random, ranges.least_bias, ranges.most_bias);
  scanner.noise = between(random, ranges.least_noise, ranges.most_noise);
  made.scan = perturbed(made.scan, made.tissue, scanner, unsigned(random()));
  return made;
}

}  // namespace facenav::evaluation
