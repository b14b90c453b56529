#include "facenav/efield/current_arrows.h"

#include "facenav/efield/coil_source.h"
#include "layer_fit.h"

namespace facenav::efield {

std::vector<CurrentArrow> currentArrows(const CoilDipoles& coil, double spacing_mm) {
  constexpr double kAroundCoil_mm = 20, kWeakest = 0.4;
  std::vector<CurrentArrow> arrows;
  if (coil.positions_mm.cols() == 0) return arrows;
  const Eigen::Vector2d low = coil.positions_mm.topRows<2>().rowwise().minCoeff().array() - kAroundCoil_mm;
  const Eigen::Vector2d high = coil.positions_mm.topRows<2>().rowwise().maxCoeff().array() + kAroundCoil_mm;
  // Few dipoles stand for a whole winding: from 8 mm below it their sum is smooth.
  const double z_mm = std::max(0.0, coil.positions_mm.row(2).maxCoeff() + 8);
  const Eigen::Matrix3Xd points = planePoints(low, high, z_mm, spacing_mm);
  Eigen::Matrix3Xd potential = potentialOf(coil, points);
  potential.row(2).setZero();
  const Eigen::VectorXd strength = potential.colwise().norm().transpose();
  const double largest = strength.maxCoeff();
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (strength[i] > 0 && strength[i] >= kWeakest * largest)
      arrows.push_back({points.col(i), potential.col(i) / strength[i], strength[i] / largest});
  return arrows;
}

}  // namespace facenav::efield
