#include "facenav/anatomy/front_relief.h"

#include <algorithm>

namespace facenav::anatomy {

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

}  // namespace facenav::anatomy
