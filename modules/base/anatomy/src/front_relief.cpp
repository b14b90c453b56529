#include "facenav/anatomy/front_relief.h"

#include <algorithm>
#include <cmath>

#include "facenav/core/robust_statistics.h"

namespace facenav::anatomy {
namespace {

/// Median difference between both sides of `column`, without the head's rotation (a constant per distance).
double asymmetry(const FrontRelief& relief, int column) {
  double sum = 0;
  int n = 0;
  for (int k = 2; k <= 24; k += 2) {
    std::vector<double> differences;
    for (int row = 8; row < relief.rows(); ++row) {
      const double a = relief.at(row, column - k), b = relief.at(row, column + k);
      if (a > FrontRelief::kNone && b > FrontRelief::kNone) differences.push_back(a - b);
    }
    if (differences.size() < 10) return std::numeric_limits<double>::max();
    const double turn = upperMedian(differences);
    for (double& d : differences) d = std::abs(d - turn);
    // The rotation itself has a small weight: at the midline both sides are also equally far forward.
    sum += upperMedian(differences) + 0.3 * std::abs(turn);
    ++n;
  }
  return sum / n;
}

}  // namespace

FrontRelief::FrontRelief(const std::vector<Eigen::Vector3d>& skin_mm, const Grid& grid) : grid_(grid) {
  Eigen::Vector3d low = skin_mm.front(), high = low;
  for (const auto& v : skin_mm) low = low.cwiseMin(v), high = high.cwiseMax(v);
  const bool is_from_top = grid.first_row == FirstRow::top;
  left_mm_ = low.x();
  first_z_mm_ = is_from_top ? high.z() : low.z();
  z_sign_ = is_from_top ? -1 : 1;
  columns_ = int((high.x() - low.x()) / grid.cell_mm) + 1;
  rows_ = int((high.z() - low.z()) / grid.cell_mm) + 1;
  forward_mm_.assign(std::size_t(rows_) * std::size_t(columns_), kNone);
  for (const auto& v : skin_mm) {
    if (v.y() < high.y() - grid.depth_mm) continue;
    const auto column = std::size_t((v.x() - left_mm_) / grid.cell_mm),
               row = std::size_t(z_sign_ * (v.z() - first_z_mm_) / grid.cell_mm);
    double& cell = forward_mm_[row * std::size_t(columns_) + column];
    cell = std::max(cell, v.y());
  }
}

int FrontRelief::cells(double mm) const { return int(std::lround(mm / grid_.cell_mm)); }

int midlineColumn(const FrontRelief& relief) {
  const int middle = relief.columns() / 2;
  int best = middle;
  double least = std::numeric_limits<double>::max();
  for (int column = middle - 10; column <= middle + 10; ++column) {
    const double here = asymmetry(relief, column);
    if (here < least) least = here, best = column;
  }
  return best;
}

}  // namespace facenav::anatomy
