#include "hand_mesh.h"

#include "optics/shapes.h"

namespace facenav::room {

surface::TriangleMesh handMesh() {
  auto mesh = ellipsoid({0, 0, 0}, {38, 48, 14}, 32);
  for (int finger = 0; finger < 4; ++finger)
    mesh = joined(mesh,
                  ellipsoid({-27.0 + 18.0 * finger, -75.0 - (finger % 3 ? 8.0 : 0.0), 0}, {8.5, 42, 8}, 20));
  mesh = joined(mesh, ellipsoid({48, -15, 0}, {30, 10, 9}, 20));
  return joined(mesh, ellipsoid({0, 150, 0}, {30, 130, 26}, 24));
}

}  // namespace facenav::room
