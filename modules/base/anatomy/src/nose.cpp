#include "facenav/anatomy/nose.h"

#include <algorithm>

namespace facenav::anatomy {
namespace {

/// Height of the cell above the skin beside it; both sides are needed. kNone if one is missing.
double protrusion_mm(const FrontRelief& relief, int row, int column) {
  const double here = relief.at(row, column);
  if (here == FrontRelief::kNone) return FrontRelief::kNone;
  double least = 1e6;
  for (const int side : {-1, 1}) {
    double sum = 0;
    int count = 0;
    for (int step = 6; step <= 8; ++step) {
      const double beside = relief.at(row, column + side * step);
      if (beside != FrontRelief::kNone) sum += beside, ++count;
    }
    if (count == 0) return FrontRelief::kNone;
    least = std::min(least, here - sum / count);
  }
  return least;
}

}  // namespace

Eigen::Vector3d findNoseTip(const std::vector<Eigen::Vector3d>& skin_mm) {
  // Cells of 4 mm: 6 to 8 of them are the cheeks 25-35 mm beside the nose.
  const FrontRelief relief(skin_mm, {4.0, FrontRelief::FirstRow::bottom, 60.0});
  double best = FrontRelief::kNone;
  for (int row = 0; row < relief.rows(); ++row)
    for (int column = 0; column < relief.columns(); ++column)
      best = std::max(best, protrusion_mm(relief, row, column));
  // The bridge stands out from the eyes as far as the tip from the cheeks; the tip lies foremost.
  const auto isNose = [&](int row, int column) { return protrusion_mm(relief, row, column) >= 0.6 * best; };
  double foremost = FrontRelief::kNone;
  for (int row = 0; row < relief.rows(); ++row)
    for (int column = 0; column < relief.columns(); ++column)
      if (isNose(row, column)) foremost = std::max(foremost, relief.at(row, column));
  // If the scan's edge cuts the nose off, the middle of the flat rim is used.
  constexpr double kTip_mm = 1.5;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (int row = 0; row < relief.rows(); ++row)
    for (int column = 0; column < relief.columns(); ++column)
      if (isNose(row, column) && relief.at(row, column) > foremost - kTip_mm)
        sum += relief.middleOf(row, column), ++count;
  return sum / std::max(1, count);
}

}  // namespace facenav::anatomy
