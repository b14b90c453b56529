#include "evaluate/mirrored_scan.h"

namespace facenav::app {

surface::ScalpSurface mirrored(surface::ScalpSurface scalp) {
  for (auto& p : scalp.mesh.vertices_mm) p.x() = -p.x();
  for (auto& n : scalp.mesh.normals) n.x() = -n.x();
  for (auto& triangle : scalp.mesh.triangles) std::swap(triangle[1], triangle[2]);
  for (auto& [point, normal] : scalp.field_of_view)
    point.mm.x() = -point.mm.x(), normal.v.x() = -normal.v.x();
  return scalp;
}

}  // namespace facenav::app
