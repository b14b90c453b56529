#pragma once
// The front of the head as a relief: how far forward (Mri +y) the skin lies over a grid of x and z.

#include <vector>

#include "facenav/surface/triangle_mesh.h"

namespace facenav::surface {

struct FaceRelief {
  static constexpr double kCell_mm = 2.5;
  static constexpr float kNone = -1e6f;

  int columns = 0, rows = 0;           // column 0: left-most x; row 0: top of the head
  double left_mm = 0.0, top_mm = 0.0;  // x of column 0, z of row 0
  std::vector<float> forward_mm;       // rows x columns, kNone where there is no skin
  int midline = 0;                     // the column about which the front is most symmetric

  float at(int row, int column) const {
    return row < 0 || row >= rows || column < 0 || column >= columns ? kNone
                                                                     : forward_mm[row * columns + column];
  }
  double z_mm(int row) const { return top_mm - row * kCell_mm; }
  double x_mm(int column) const { return left_mm + column * kCell_mm; }
};

FaceRelief reliefOf(const TriangleMesh& scalp);

}  // namespace facenav::surface
