#pragma once
// The mean face's relief: front heights over a quadratic surface, made symmetric.

namespace facenav::anatomy {

struct MeanFace {
  static constexpr int kRows = 30, kHalf = 15, kColumns = 2 * kHalf - 1;
  static constexpr double kCell_mm = 3, kTop_mm = 30;  // row 0 lies this far above the nasion
  static constexpr double kReach_mm = (kHalf - 1) * kCell_mm;

  /// Height at `row` (downwards) and `column` (from one side to the other), mm.
  static double height_mm(int row, int column);
  static constexpr double across_mm(int column) { return (column - (kHalf - 1)) * kCell_mm; }
  static constexpr double up_mm(int row) { return kTop_mm - row * kCell_mm; }
};

}  // namespace facenav::anatomy
