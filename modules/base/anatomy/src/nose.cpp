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

double sides_mm(const FrontRelief& relief, int midline, int row, double beside_mm) {
  const double a = relief.at(row, midline - relief.cells(beside_mm)),
               b = relief.at(row, midline + relief.cells(beside_mm));
  return a > FrontRelief::kNone && b > FrontRelief::kNone ? 0.5 * (a + b) : FrontRelief::kNone;
}

double prominence_mm(const FrontRelief& relief, int midline, int row) {
  constexpr double kRidge_mm = 10, kCheek_mm = 30;
  double middle = FrontRelief::kNone;
  for (int c = -relief.cells(kRidge_mm); c <= relief.cells(kRidge_mm); ++c)
    middle = std::max(middle, relief.at(row, midline + c));
  const double sides = sides_mm(relief, midline, row, kCheek_mm);
  return middle > FrontRelief::kNone && sides > FrontRelief::kNone ? middle - sides : FrontRelief::kNone;
}

std::optional<NoseRise> findNoseRise(const FrontRelief& relief, int midline) {
  // A nose is 8 to 45 mm long from where it begins to rise. It ends before mouth and chin, which stand out
  // too.
  constexpr double kForehead_mm = 50, kShortest_mm = 8, kLongest_mm = 45, kStep_mm = 0.5, kSurely_mm = 12;
  std::optional<NoseRise> best;
  for (int root = relief.cells(kForehead_mm); root < relief.rows(); ++root) {
    const double at_root = prominence_mm(relief, midline, root);
    if (at_root <= FrontRelief::kNone) continue;
    const int last = std::min(root + relief.cells(kLongest_mm), relief.rows() - 1);
    for (int crest = root + relief.cells(kShortest_mm); crest <= last; ++crest) {
      const double there = prominence_mm(relief, midline, crest);
      if (there > FrontRelief::kNone && there - at_root > (best ? best->rise_mm : 0.0) + kStep_mm)
        best = NoseRise{root, crest, there - at_root};
    }
    if (best && best->rise_mm > kSurely_mm && root > best->crest_row) break;  // the first from above counts
  }
  return best;
}

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
