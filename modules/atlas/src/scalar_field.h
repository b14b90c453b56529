#pragma once
// ScalarField: one float per node of a regular grid, i fastest. The registration's arithmetic: sampling,
// gradients, running means. Slices are worked on in parallel.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "facenav/volume/for_slices.h"

namespace facenav::atlas {

struct ScalarField {
  std::array<int, 3> size{0, 0, 0};
  std::vector<float> values;

  ScalarField() = default;
  explicit ScalarField(const std::array<int, 3>& grid_size)
      : size(grid_size), values(std::size_t(grid_size[0]) * grid_size[1] * grid_size[2], 0.f) {}
  std::size_t index(int i, int j, int k) const {
    return i + std::size_t(size[0]) * (j + std::size_t(size[1]) * k);
  }
  float at(int i, int j, int k) const { return values[index(i, j, k)]; }
};
using VectorField = std::array<ScalarField, 3>;

/// Trilinear at continuous node coordinates; places beyond the grid take its edge's value.
float sample(const ScalarField& field, const Eigen::Vector3f& at);
/// Mean over (2 radius + 1)^3 nodes, by running sums; at the edge over those that are there.
ScalarField boxMean(const ScalarField& field, int radius);
/// `passes` times the mean of 3 x 3 x 3 nodes: variance 2/3 passes.
ScalarField smoothed(ScalarField field, int passes);
/// Central differences per node.
Eigen::Vector3f gradientAt(const ScalarField& field, int i, int j, int k);
using volume::forSlices;

}  // namespace facenav::atlas
