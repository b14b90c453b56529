#include "spherical_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "facenav/core/error.h"
#include "insideness.h"

namespace facenav::surface {
namespace {

using Eigen::Vector3d;
using volume::Mask;
using volume::Volume;

constexpr double kGrid_mm = 1.0;  // grid of the smoothed mask for the surface search
constexpr double kStep_mm = 0.5;  // step along a ray
constexpr float kInside = 0.5f;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

Vector3d centreOf(const Volume& inside) {
  Vector3d sum = Vector3d::Zero();
  double weight = 0;
  std::size_t at = 0;
  for (int k = 0; k < inside.grid.size[2]; ++k)
    for (int j = 0; j < inside.grid.size[1]; ++j)
      for (int i = 0; i < inside.grid.size[0]; ++i, ++at)
        if (inside.voxels[at] > kInside) sum += Vector3d(i, j, k), weight += 1;
  if (weight == 0) throw Error("the brain mask is too small for a surface");
  return inside.grid.mri_from_voxel * (sum / weight);
}

/// Values along rays from one point; directions are given in Mri.
struct Ray {
  Ray(const Volume& v, const Vector3d& from_mm, const Vector3d& direction)
      : volume(v),
        from(v.grid.toVoxel(Point<Mri>(from_mm))),
        step(v.grid.mri_from_voxel.linear().inverse() * direction) {}
  float at(double mm) const { return volume::sampleLinear(volume, from + mm * step); }
  const Volume& volume;
  Vector3d from, step;
};

/// Distance of the outermost crossing of the surface, or NaN.
float outermost(const Ray& inside, double from_mm) {
  float outer = inside.at(from_mm);
  for (double r = from_mm - kStep_mm; r > 0; r -= kStep_mm) {
    const float value = inside.at(r);
    if (value >= kInside)
      return float(r + kStep_mm * (value - kInside) / std::max(1e-6f, value - std::min(outer, kInside)));
    outer = value;
  }
  return kUnknown;
}

/// Mean value over the peel, beginning half a millimetre inside the surface: at the edge, voxels mix with the
/// outside.
float colourAlong(const Ray& ray, double radius_mm, double peel_mm) {
  float sum = 0;
  int count = 0;
  for (double depth = 0.5; depth <= std::max(0.5, peel_mm) + 1e-9; depth += 0.5, ++count)
    sum += ray.at(std::max(0.0, radius_mm - depth));
  return sum / float(count);
}

/// Fills empty bins with the mean of their filled neighbours, from the rim of each gap inwards.
void fillGaps(std::vector<float>& bins, int rows, int columns) {
  for (bool has_gap = true; has_gap;) {
    has_gap = false;
    const std::vector<float> from = bins;
    bool has_moved = false;
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        if (!std::isnan(from[r * columns + c])) continue;
        float sum = 0;
        int count = 0;
        for (int dr = -1; dr <= 1; ++dr)
          for (int dc = -1; dc <= 1; ++dc) {
            // Across a pole the neighbour is on the opposite meridian.
            const int row = std::clamp(r + dr, 0, rows - 1), turn = r + dr == row ? 0 : columns / 2;
            const float v = from[row * columns + (c + dc + turn + columns) % columns];
            if (!std::isnan(v)) sum += v, ++count;
          }
        if (count) bins[r * columns + c] = sum / float(count), has_moved = true;
        has_gap |= count == 0;
      }
    if (has_gap && !has_moved) throw Error("the brain mask has no surface around its centre");
  }
}

/// Maps to 0..255 the grey values from the 2nd percentile (fluid in the sulci) to 1.25 times the 75th (the
/// crowns of the gyri). A higher end would depend on the bare white matter of the brainstem, seen from below.
/// All bins have equal weight.
std::vector<std::uint8_t> windowed(const std::vector<float>& values) {
  std::vector<float> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const float low = sorted[sorted.size() * 2 / 100],
              high = low + 1.25f * (sorted[sorted.size() * 3 / 4] - low);
  std::vector<std::uint8_t> grey(values.size());
  for (std::size_t i = 0; i < grey.size(); ++i)
    grey[i] = std::uint8_t(
        std::lround(255 * std::clamp((values[i] - low) / std::max(1e-6f, high - low), 0.f, 1.f)));
  return grey;
}

}  // namespace

SphericalAngles toAngles(const Point<Mri>& p, const Point<Mri>& centre) {
  const Vector3d d = p.mm - centre.mm;
  return {std::acos(std::clamp(d.y() / std::max(1e-12, d.norm()), -1.0, 1.0)), std::atan2(d.z(), d.x())};
}

Direction<Mri> toDirection(const SphericalAngles& a) {
  const double s = std::sin(a.phi_rad);
  return Direction<Mri>(Vector3d(s * std::cos(a.theta_rad), std::cos(a.phi_rad), s * std::sin(a.theta_rad)));
}

SphericalMap mapBrain(const Volume& volume, const Mask& brain, const BrainModelOptions& options,
                      TaskMonitor& monitor) {
  if (options.rows < 4 || options.columns < 4) throw Error("a brain model needs at least 4 x 4 bins");
  monitor.report("smoothing the brain's surface", 0);
  const Volume inside = insideness(brain, kGrid_mm);
  SphericalMap map;
  map.rows = options.rows, map.columns = options.columns;
  map.centre = Point<Mri>(centreOf(inside));
  const double far_mm =
      0.5 * kGrid_mm * Vector3d(inside.grid.size[0], inside.grid.size[1], inside.grid.size[2]).norm() +
      (inside.grid.centre().mm - map.centre.mm).norm();
  std::vector<float> radius(std::size_t(map.rows) * map.columns), value(radius.size(), kUnknown);
  std::size_t bin = 0;
  for (int r = 0; r < map.rows; ++r) {
    monitor.report("mapping the brain's surface", double(r) / map.rows);
    for (int c = 0; c < map.columns; ++c, ++bin) {
      const Vector3d d =
          toDirection({(r + 0.5) * M_PI / map.rows, -M_PI + (c + 0.5) * 2 * M_PI / map.columns}).v;
      radius[bin] = outermost(Ray(inside, map.centre.mm, d), far_mm);
      if (!std::isnan(radius[bin]))
        value[bin] = colourAlong(Ray(volume, map.centre.mm, d), radius[bin], options.peel_mm);
    }
  }
  fillGaps(radius, map.rows, map.columns);
  fillGaps(value, map.rows, map.columns);
  map.radius_mm.assign(radius.begin(), radius.end());
  map.colour = windowed(value);
  return map;
}

}  // namespace facenav::surface
