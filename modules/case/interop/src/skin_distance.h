#pragma once
// Distance of a coil's centre from the skin, to judge poses of another program.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace facenav::interop {

/// Distance to the nearest of these points, mm; nothing without points.
inline std::optional<double> fromSkin_mm(const std::vector<Eigen::Vector3d>& skin_mm,
                                         const Eigen::Vector3d& p_mm) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& q_mm : skin_mm) best = std::min(best, (q_mm - p_mm).squaredNorm());
  if (skin_mm.empty() || !std::isfinite(best)) return std::nullopt;
  return std::sqrt(best);
}

}  // namespace facenav::interop
