#include "edge_width.h"

#include <algorithm>

namespace facenav::surface {

std::vector<float> edgeWidth_mm(const TriangleMesh& mesh, const volume::Volume& scan) {
  constexpr double kDeep_mm = 5, kOut_mm = 6, kNear_mm = 2, kEvery_mm = 0.5, kWidest_mm = 20;
  std::vector<float> widths;
  widths.reserve(mesh.vertices_mm.size());
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
    const auto valueAt = [&](double t) {
      return volume::sampleLinear(scan,
                                  scan.grid.toVoxel(Point<Mri>(mesh.vertices_mm[v] + t * mesh.normals[v])));
    };
    float tissue = -1e30f, air = 1e30f, slope = 0, before = 0;
    for (double t = -kDeep_mm; t <= kOut_mm; t += kEvery_mm) {
      const auto value = float(valueAt(t));
      if (t <= 0) tissue = std::max(tissue, value);
      if (t >= 0) air = std::min(air, value);
      if (t > -kNear_mm && t <= kNear_mm) slope = std::max(slope, (before - value) / float(kEvery_mm));
      before = value;
    }
    widths.push_back(slope > 0 ? std::min(float(kWidest_mm), (tissue - air) / slope) : float(kWidest_mm));
  }
  return widths;
}

}  // namespace facenav::surface
