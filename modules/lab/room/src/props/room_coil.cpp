#include "facenav/room/room_coil.h"

#include "marker_plate.h"
#include "optics/shapes.h"

namespace facenav::room {
namespace {

constexpr double kWing_mm = 16.0;  // thickness of the wings

/// The end of the stem at the plate: behind the plate's edge nearest to the coil, so that the stem never
/// crosses the print.
Eigen::Vector3d stemEnd(const RoomCoil& coil) {
  const Eigen::Vector3d coil_mm = (coil.marker_T_coil * Point<Coil>(0.0, 0.0, 0.0)).mm;
  const double edge_mm = kPlatePerMarker * 0.5 * coil.marker_size_mm - 7.0;
  Eigen::Vector3d best(0.0, 0.0, 0.0);
  double nearest = 1e9;
  for (const Eigen::Vector2d& side :
       {Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(0, -1)}) {
    const Eigen::Vector3d end(edge_mm * side.x(), edge_mm * side.y(), kPlateThickness_mm + 4.0);
    if ((end - coil_mm).norm() < nearest) nearest = (end - coil_mm).norm(), best = end;
  }
  return (coil.marker_T_coil.inverse() * Point<Marker>(best)).mm;
}

}  // namespace

surface::TriangleMesh coilBodyMesh() {
  auto mesh =
      joined(cylinder({-42.0, 0.0}, 45.0, -kWing_mm, 0.0), cylinder({42.0, 0.0}, 45.0, -kWing_mm, 0.0));
  mesh = joined(mesh, box({-20.0, -40.0, -kWing_mm - 8.0}, {20.0, 22.0, -kWing_mm}));
  return joined(mesh, box({-14.0, -190.0, -kWing_mm - 14.0}, {14.0, -38.0, -2.0}));
}

surface::TriangleMesh coilMesh(const RoomCoil& coil) {
  return joined(coilBodyMesh(), bar({0.0, 0.0, -kWing_mm}, stemEnd(coil), 12.0));
}

}  // namespace facenav::room
