#include "facenav/volume/map_peak.h"

#include <array>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::volume {
namespace {

using Eigen::Vector3d;
using Voxel = std::array<int, 3>;

/// Calls take(voxel, value) for the finite voxels whose centres lie in the ball.
template <class Take>
void forVoxelsIn(const Volume& map, const Vector3d& centre_mm, double radius_mm, Take take) {
  for (int k = 0; k < map.grid.size[2]; ++k)
    for (int j = 0; j < map.grid.size[1]; ++j)
      for (int i = 0; i < map.grid.size[0]; ++i) {
        const float value = map.at(i, j, k);
        if (!std::isfinite(value)) continue;
        if ((map.grid.toMri(Vector3d(i, j, k)).mm - centre_mm).norm() <= radius_mm)
          take(Voxel{i, j, k}, value);
      }
}

/// Offset in voxels of the peak of the parabola through a voxel and its neighbours along one axis; 0 if there
/// is none.
double parabola(const Volume& map, const Voxel& at, std::size_t axis) {
  Voxel before = at, after = at;
  --before[axis], ++after[axis];
  if (!map.grid.contains(before[0], before[1], before[2]) || !map.grid.contains(after[0], after[1], after[2]))
    return 0;
  const double a = map.at(before[0], before[1], before[2]), b = map.at(at[0], at[1], at[2]),
               c = map.at(after[0], after[1], after[2]);
  const double bend = a - 2 * b + c;
  const bool is_extreme = (b > a && b > c) || (b < a && b < c);
  return is_extreme && std::isfinite(bend) ? 0.5 * (a - c) / bend : 0;
}

}  // namespace

MapPeak peakWithin(const Volume& map, const Vector3d& centre_mm, double radius_mm, PeakOf wanted) {
  const double sign = wanted == PeakOf::highest ? 1.0 : -1.0;
  std::optional<Voxel> best;
  double most = 0, least = 0;
  forVoxelsIn(map, centre_mm, radius_mm, [&](const Voxel& at, double value) {
    if (!best || sign * value < least) least = sign * value;
    if (!best || sign * value > most) most = sign * value, best = at;
  });
  if (!best)
    throw Error(formatted("the map has no value within %g mm of %.0f %.0f %.0f", radius_mm, centre_mm.x(),
                          centre_mm.y(), centre_mm.z()),
                {}, "check the place, and whether the map is in MNI or the patient's space");
  if (!(most > least)) throw Error("the map has one value everywhere in that region", {}, "check the region");
  Vector3d ijk((*best)[0], (*best)[1], (*best)[2]);
  const double step_mm = map.grid.spacing_mm().maxCoeff();
  MapPeak peak;
  peak.is_at_edge = (map.grid.toMri(ijk).mm - centre_mm).norm() > radius_mm - step_mm;
  for (std::size_t axis = 0; axis < 3; ++axis) ijk[Eigen::Index(axis)] += parabola(map, *best, axis);
  peak.place_mm = map.grid.toMri(ijk).mm;
  peak.value = map.at((*best)[0], (*best)[1], (*best)[2]);
  return peak;
}

MapSpace spaceOfMap(const NiftiRead& map, std::optional<MapSpace> stated, const std::filesystem::path& file) {
  if (!stated && !map.is_template_space)
    throw Error("the file does not say that the map lies in a template's space", file.string(),
                "give --map-space mni, or --map-space mri if it lies on the patient's MRI");
  if (stated == MapSpace::mri && map.is_template_space)
    throw Error("the file says that the map lies in a template's space, not the patient's", file.string(),
                "give --map-space mni");
  return stated.value_or(MapSpace::mni);
}

}  // namespace facenav::volume
