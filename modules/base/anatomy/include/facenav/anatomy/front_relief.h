#pragma once
// The front of the head as a relief: how far forward (Mri +y) the skin lies over a grid of x and z. Used to
// find the nose (nose.h). Coarse cells from points, in Mri. skin_relief.h is finer, made of triangles, in the
// head's own axes.

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace facenav::anatomy {

class FrontRelief {
 public:
  static constexpr double kNone = -1e6;  // no skin in that cell
  enum class FirstRow { top, bottom };   // the head's end that row 0 shows
  struct Grid {
    double cell_mm;
    FirstRow first_row;
    /// Skin that lies more than this behind the foremost point is left out: the back of the head, seen
    /// through a hole.
    double depth_mm = std::numeric_limits<double>::infinity();
  };

  /// Builds the relief from `skin_mm` (at least one skin point, Mri). Each cell keeps its foremost point.
  FrontRelief(const std::vector<Eigen::Vector3d>& skin_mm, const Grid& grid);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Forward position of the skin (Mri y), mm; kNone outside the grid and where there is no skin.
  double at(int row, int column) const {
    return row < 0 || row >= rows_ || column < 0 || column >= columns_
               ? kNone
               : forward_mm_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)];
  }
  /// The edge at which a row or column begins, Mri mm.
  double z_mm(int row) const { return first_z_mm_ + z_sign_ * row * grid_.cell_mm; }
  double x_mm(int column) const { return left_mm_ + column * grid_.cell_mm; }
  /// Centre of the cell at the height of its skin, Mri mm.
  Eigen::Vector3d middleOf(int row, int column) const {
    return {left_mm_ + (column + 0.5) * grid_.cell_mm, at(row, column),
            first_z_mm_ + z_sign_ * (row + 0.5) * grid_.cell_mm};
  }

 private:
  Grid grid_;
  double left_mm_ = 0, first_z_mm_ = 0, z_sign_ = -1;  // z_sign_: -1 where rows go down
  int columns_ = 0, rows_ = 0;
  std::vector<double> forward_mm_;
};

}  // namespace facenav::anatomy
