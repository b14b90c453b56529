#include "light_field.h"

#include <cmath>

namespace facenav::head_tracking {
namespace {

constexpr float kMostChange =
    0.35f;  // difference of a neighbour's ratio from the patch's own; more: edge of a shadow
constexpr float kRidge_px2 = 150.f;  // prefers no slope if few neighbours lie on one side

}  // namespace

Eigen::Vector2f lightSlope(const std::vector<Neighbour>& neighbours, const PatchMeasurements& measurements,
                           std::size_t patch, int camera) {
  const float own = measurements[patch][camera].brightness;
  float n = 0, x = 0, y = 0, r = 0, xx = 0, xy = 0, yy = 0, xr = 0, yr = 0;
  for (const auto& neighbour : neighbours) {
    const PatchMeasurement& measurement = measurements[neighbour.patch][camera];
    const float change = measurement.brightness - own;
    if (!measurement.is_visible || std::abs(change) > kMostChange * own) continue;
    const float w = std::max(0.f, measurement.ncc), u = neighbour.right_px, v = neighbour.down_px;
    n += w, x += w * u, y += w * v, r += w * change;
    xx += w * u * u, xy += w * u * v, yy += w * v * v, xr += w * u * change, yr += w * v * change;
  }
  if (!(n > 0.f) || own < 0.05f) return Eigen::Vector2f::Zero();
  xx += kRidge_px2 - x * x / n, yy += kRidge_px2 - y * y / n, xy -= x * y / n;
  xr -= x * r / n, yr -= y * r / n;
  const float determinant = xx * yy - xy * xy;
  return Eigen::Vector2f(yy * xr - xy * yr, xx * yr - xy * xr) / (determinant * own);
}

}  // namespace facenav::head_tracking
