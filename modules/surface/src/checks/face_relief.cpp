#include "face_relief.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "facenav/core/robust_statistics.h"

namespace facenav::surface {
namespace {

/// Median difference between both sides of `column`, the head's turn (a constant per distance) taken out.
double asymmetry(const FaceRelief& relief, int column) {
  double sum = 0;
  int n = 0;
  for (int k = 2; k <= 24; k += 2) {
    std::vector<float> differences;
    for (int row = 8; row < relief.rows; ++row) {
      const float a = relief.at(row, column - k), b = relief.at(row, column + k);
      if (a > FaceRelief::kNone && b > FaceRelief::kNone) differences.push_back(a - b);
    }
    if (differences.size() < 10) return std::numeric_limits<double>::max();
    const float turn = upperMedian(differences);
    for (float& d : differences) d = std::abs(d - turn);
    // The turn itself counts a little: the midline is also where both sides are equally far forward.
    sum += upperMedian(differences) + 0.3 * std::abs(turn);
    ++n;
  }
  return sum / n;
}

}  // namespace

FaceRelief reliefOf(const TriangleMesh& scalp) {
  FaceRelief relief;
  Eigen::Vector3d low = scalp.vertices_mm.front(), high = low;
  for (const auto& v : scalp.vertices_mm) low = low.cwiseMin(v), high = high.cwiseMax(v);
  relief.left_mm = low.x();
  relief.top_mm = high.z();
  relief.columns = int((high.x() - low.x()) / FaceRelief::kCell_mm) + 1;
  relief.rows = int((high.z() - low.z()) / FaceRelief::kCell_mm) + 1;
  relief.forward_mm.assign(std::size_t(relief.rows) * relief.columns, FaceRelief::kNone);
  for (const auto& v : scalp.vertices_mm) {
    const int column = int((v.x() - low.x()) / FaceRelief::kCell_mm),
              row = int((high.z() - v.z()) / FaceRelief::kCell_mm);
    float& cell = relief.forward_mm[row * relief.columns + column];
    cell = std::max(cell, float(v.y()));
  }
  double least = std::numeric_limits<double>::max();
  relief.midline = relief.columns / 2;
  for (int column = relief.columns / 2 - 10; column <= relief.columns / 2 + 10; ++column) {
    const double here = asymmetry(relief, column);
    if (here < least) least = here, relief.midline = column;
  }
  return relief;
}

}  // namespace facenav::surface
