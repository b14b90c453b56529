#pragma once
// ScalarField: one float per node of a regular grid, i fastest. Sampling, gradients and running means for the
// registration. Slices are processed in parallel.

#include <Eigen/Core>
#include <algorithm>
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

/// The eight nodes around a position, computed once for all fields of one grid. Positions beyond the grid use
/// the values at its edge.
class Cell {
 public:
  Cell(const std::array<int, 3>& size, const Eigen::Vector3f& at) {
    std::size_t stride = 1;
    for (int a = 0; a < 3; ++a) {
      const float x = std::min(std::max(at[a], 0.f), float(size[a] - 1));
      const int low = std::min(int(x), std::max(0, size[a] - 2));
      part_[a] = x - float(low);
      first_ += std::size_t(low) * stride;
      step_[a] = size[a] > 1 ? stride : 0;
      stride *= std::size_t(size[a]);
    }
  }
  /// Trilinear value.
  float of(const ScalarField& field) const {
    const float* v = &field.values[first_];
    const auto row = [&](const float* p) { return p[0] + part_[0] * (p[step_[0]] - p[0]); };
    const auto plane = [&](const float* p) {
      const float a = row(p);
      return a + part_[1] * (row(p + step_[1]) - a);
    };
    const float a = plane(v);
    return a + part_[2] * (plane(v + step_[2]) - a);
  }

 private:
  std::size_t first_ = 0, step_[3];
  float part_[3];
};

/// Trilinear value at continuous node coordinates; beyond the grid the value at its edge.
float sample(const ScalarField& field, const Eigen::Vector3f& at);
/// Mean over (2 radius + 1)^3 nodes, by running sums; at the edge over the nodes that exist.
ScalarField boxMean(const ScalarField& field, int radius);
/// Applies the mean of 3 x 3 x 3 nodes `passes` times: adds variance 2/3 passes.
ScalarField smoothed(ScalarField field, int passes);
/// Central differences per node.
inline Eigen::Vector3f gradientAt(const ScalarField& f, int i, int j, int k) {
  const std::array<int, 3> at{i, j, k};
  const std::size_t here = f.index(i, j, k);
  std::size_t stride = 1;
  Eigen::Vector3f g;
  for (int a = 0; a < 3; ++a) {
    const bool has_low = at[a] > 0, has_high = at[a] + 1 < f.size[a];
    const float difference =
        f.values[here + (has_high ? stride : 0)] - f.values[here - (has_low ? stride : 0)];
    g[a] = has_low && has_high ? 0.5f * difference : difference;
    stride *= std::size_t(f.size[a]);
  }
  return g;
}
using volume::forSlices;

}  // namespace facenav::atlas
