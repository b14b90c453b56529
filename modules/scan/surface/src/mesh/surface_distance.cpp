#include "facenav/surface/surface_distance.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace facenav::surface {

std::vector<float> signedDistances_mm(const TriangleMesh& from, const TriangleMesh& to, int step) {
  const ClosestPoint nearest(to);
  const auto count = vtkIdType((from.vertices_mm.size() + std::size_t(step) - 1) / std::size_t(step));
  std::vector<float> distances(static_cast<std::size_t>(count));
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    std::optional<int> near;
    for (vtkIdType n = begin; n < end; ++n) {
      const auto found =
          nearest.nearest(Point<Mri>(from.vertices_mm[std::size_t(n) * std::size_t(step)]), near);
      near = found.triangle;
      distances[std::size_t(n)] = float(found.is_outside ? found.distance_mm : -found.distance_mm);
    }
  });
  return distances;
}

SurfaceDistance summarise(const std::vector<float>& signed_distances_mm) {
  std::vector<float> sizes;
  for (float d : signed_distances_mm) sizes.push_back(std::abs(d));
  if (sizes.empty()) return {};
  std::sort(sizes.begin(), sizes.end());
  const auto at = [&](double share) { return double(sizes[std::size_t(share * double(sizes.size() - 1))]); };
  return {at(0.5), at(0.95), at(1)};
}

}  // namespace facenav::surface
