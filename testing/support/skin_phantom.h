#pragma once
// A head phantom with a skin known in closed form: an ellipsoid with a nose, in layers as in T1 MR (dark
// dermis over bright fat over dark bone over brain), blurred by the scanner's point spread, with noise, on
// any grid.

#include <algorithm>
#include <cmath>
#include <random>

#include "facenav/volume/volume.h"

namespace facenav::testing {

struct SkinPhantom {
  double dermis_mm = 2.0, dermis_level = 45.0, fat_mm = 4.0, fat_level = 120.0, brain_level = 80.0;
  double blur_mm = 0.5, noise = 2.0;
  double scale = 1.0, offset = 0.0;  // of the intensities
  std::uint32_t seed = 1;
  Eigen::Vector3d head_mm{75, 95, 115}, nose_mm{15, 26, 28}, nose_at_mm{0, 84, -30};

  static double toEllipsoid(const Eigen::Vector3d& p, const Eigen::Vector3d& radii_mm) {
    const double k0 = p.cwiseQuotient(radii_mm).norm(),
                 k1 = p.cwiseQuotient(radii_mm.cwiseProduct(radii_mm)).norm();
    return k1 > 0 ? k0 * (k0 - 1) / k1 : -radii_mm.minCoeff();
  }
  double toHead(const Eigen::Vector3d& p_mm) const { return toEllipsoid(p_mm, head_mm); }
  double toNose(const Eigen::Vector3d& p_mm) const { return toEllipsoid(p_mm - nose_at_mm, nose_mm); }
  /// Signed distance to the skin, exact to first order near it; positive outside.
  double toSkin(const Eigen::Vector3d& p_mm) const { return std::min(toHead(p_mm), toNose(p_mm)); }
  /// Returns true near the crease between nose and head, which no scan resolves.
  bool isNearCrease(const Eigen::Vector3d& p_mm) const { return std::abs(toHead(p_mm) - toNose(p_mm)) < 6.0; }

  double level(double distance_mm) const {
    const auto step = [&](double depth_mm) {
      return 0.5 * std::erfc((distance_mm + depth_mm) / (blur_mm * std::sqrt(2.0)));
    };
    const double bone = 10.0;
    return dermis_level * step(0) + (fat_level - dermis_level) * step(dermis_mm) +
           (bone - fat_level) * step(dermis_mm + fat_mm) +
           (brain_level - bone) * step(dermis_mm + fat_mm + 7.0);
  }

  /// Scans the phantom. `spacing_mm` along i, j, k; the grid spans from `low_mm` to `high_mm`.
  volume::Volume scan(const Eigen::Vector3d& spacing_mm, const Eigen::Vector3d& low_mm = {-100, -120, -140},
                      const Eigen::Vector3d& high_mm = {100, 130, 135}) const {
    volume::Volume out;
    for (int a = 0; a < 3; ++a) out.grid.size[a] = int((high_mm[a] - low_mm[a]) / spacing_mm[a]) + 1;
    out.grid.mri_from_voxel.linear() = spacing_mm.asDiagonal();
    out.grid.mri_from_voxel.translation() = low_mm;
    out.voxels.resize(out.grid.count());
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::size_t v = 0;
    for (int k = 0; k < out.grid.size[2]; ++k)
      for (int j = 0; j < out.grid.size[1]; ++j)
        for (int i = 0; i < out.grid.size[0]; ++i, ++v) {
          const double signal = level(toSkin(out.grid.toMri({double(i), double(j), double(k)}).mm));
          const double magnitude = std::hypot(signal + noise * normal(random), noise * normal(random));
          out.voxels[v] = float(offset + scale * magnitude);
        }
    return out;
  }
};

}  // namespace facenav::testing
