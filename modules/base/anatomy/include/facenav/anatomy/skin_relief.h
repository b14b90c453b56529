#pragma once
// The skin as a height map seen from the front, the right or the left, in the head's own axes (found by
// surface's landmarks): 1 mm cells, filled triangle by triangle, optionally smoothed.

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

namespace facenav::anatomy {

/// Heights along `toward` over two axes, all of the head frame: 0 right, 1 front, 2 up.
struct SkinRelief {
  static constexpr float kNone = -1e6f;
  int across_axis = 0, up_axis = 2;
  double left_mm = 0, bottom_mm = 0;  // coordinates of cell (0, 0)'s centre; cells are 1 mm
  int columns = 0, rows = 0;
  std::vector<float> height_mm;  // rows x columns, kNone where there is no skin

  float cell(int column, int row) const {
    return column < 0 || row < 0 || column >= columns || row >= rows
               ? kNone
               : height_mm[std::size_t(row) * columns + column];
  }
  /// Height by bilinear interpolation; nullopt if a neighbour has no skin.
  std::optional<double> at(double across_mm, double up_mm) const;
};

enum class Side { front, right, left };

/// Builds the relief from one side. `head_mm`: vertices of the skin in the head frame; `triangles`: their
/// indices. Seen from the right or left, height is the distance from the plane of symmetry.
SkinRelief reliefFrom(Side side, const std::vector<Eigen::Vector3d>& head_mm,
                      const std::vector<Eigen::Vector3i>& triangles);
/// Smooths by a Gaussian over the cells with skin.
SkinRelief smoothed(const SkinRelief& relief, double sigma_mm);

}  // namespace facenav::anatomy
