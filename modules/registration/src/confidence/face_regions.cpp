#include "face_regions.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace facenav::registration {
namespace {

constexpr double kCell_mm = 4.0;
constexpr double kNone = -1e6;

/// How far forward (+y) the front of the head lies over a grid of x and z.
struct Relief {
  static constexpr double kDepth_mm = 60.0;  // farther back is the back of the head, seen through a hole
  Eigen::Vector3d low;
  int columns, rows;
  std::vector<double> forward_mm;

  explicit Relief(const std::vector<Eigen::Vector3d>& vertices) {
    Eigen::Vector3d high = low = vertices.front();
    for (const auto& v : vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
    columns = int((high.x() - low.x()) / kCell_mm) + 1;
    rows = int((high.z() - low.z()) / kCell_mm) + 1;
    forward_mm.assign(std::size_t(columns) * rows, kNone);
    for (const auto& v : vertices) {
      if (v.y() < high.y() - kDepth_mm) continue;
      double& cell = forward_mm[std::size_t((v.z() - low.z()) / kCell_mm) * columns +
                                std::size_t((v.x() - low.x()) / kCell_mm)];
      cell = std::max(cell, v.y());
    }
  }
  Eigen::Vector3d position(int row, int column) const {
    return {low.x() + (column + 0.5) * kCell_mm, at(row, column), low.z() + (row + 0.5) * kCell_mm};
  }
  double at(int row, int column) const {
    return row < 0 || row >= rows || column < 0 || column >= columns
               ? kNone
               : forward_mm[std::size_t(row) * columns + column];
  }
};

/// How far the cell stands out from the skin beside it, both sides asked for; kNone where there is none.
double protrusion_mm(const Relief& relief, int row, int column) {
  const double here = relief.at(row, column);
  if (here == kNone) return kNone;
  double least = 1e6;
  for (const int side : {-1, 1}) {
    double sum = 0;
    int count = 0;
    for (int step = 6; step <= 8; ++step) {
      const double beside = relief.at(row, column + side * step);
      if (beside != kNone) sum += beside, ++count;
    }
    if (count == 0) return kNone;
    least = std::min(least, here - sum / count);
  }
  return least;
}

}  // namespace

Eigen::Vector3d findNoseTip(const SkinModel& skin) {
  const Relief relief(skin.points.points_mm);
  double best = kNone;
  for (int row = 0; row < relief.rows; ++row)
    for (int column = 0; column < relief.columns; ++column)
      best = std::max(best, protrusion_mm(relief, row, column));
  // The bridge stands out from the eyes as far as the tip from the cheeks; the tip lies foremost of these.
  const auto isNose = [&](int row, int column) { return protrusion_mm(relief, row, column) >= 0.6 * best; };
  double foremost = kNone;
  for (int row = 0; row < relief.rows; ++row)
    for (int column = 0; column < relief.columns; ++column)
      if (isNose(row, column)) foremost = std::max(foremost, relief.at(row, column));
  // Where the scan's edge cuts the nose off flat, the rim stands for the tip.
  constexpr double kTip_mm = 1.5;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (int row = 0; row < relief.rows; ++row)
    for (int column = 0; column < relief.columns; ++column)
      if (isNose(row, column) && relief.at(row, column) > foremost - kTip_mm)
        sum += relief.position(row, column), ++count;
  return sum / std::max(1, count);
}

std::string FaceRegions::nameOf(const Eigen::Vector3d& p_mri_mm) const {
  const Eigen::Vector3d d = p_mri_mm - nose_;
  const double aside = std::abs(d.x()), up = d.z();
  const std::string side = d.x() > 0 ? "right " : "left ";
  if (aside < 17 && up > -15 && up < 45) return "nose";
  if (aside > 60 && up > 15) return side + "temple";
  if (up > 62) return "forehead";
  if (up > 20) return aside < 12 ? "forehead" : side + "brow";
  if (up > -5) return aside > 22 ? side + "cheekbone" : "nose";
  if (aside > 62) return side + "jaw";
  if (aside > 27) return up > -55 ? side + "cheek" : side + "jaw";
  return up > -50 ? "mouth" : "chin";
}

double FaceRegions::softness(const Eigen::Vector3d& p_mri_mm) const {
  const Eigen::Vector3d d = p_mri_mm - nose_;
  const double below = std::clamp((10.0 - d.z()) / 20.0, 0.0, 1.0);
  const double from_nose = std::clamp((std::abs(d.x()) - 14.0) / 8.0, 0.0, 1.0);
  return d.z() > -12 ? below * from_nose : below;
}

double FaceRegions::foreignShare(const Eigen::Vector3d& p_mri_mm) const {
  // The hairline lies 75 to 110 mm above the tip of the nose, and falls to the ears on both sides.
  constexpr double kOnSkin = 0.05, kAboveHairline = 0.7, kLowest_mm = 60.0, kHighest_mm = 100.0;
  const Eigen::Vector3d d = p_mri_mm - nose_;
  const double above =
      std::clamp((d.z() + 0.012 * d.x() * d.x() - kLowest_mm) / (kHighest_mm - kLowest_mm), 0.0, 1.0);
  return kOnSkin + (kAboveHairline - kOnSkin) * above;
}

}  // namespace facenav::registration
