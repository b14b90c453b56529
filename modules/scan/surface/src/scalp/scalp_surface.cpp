#include "facenav/surface/scalp_surface.h"

#include <algorithm>
#include <cmath>

#include "checks/face_check.h"
#include "edge_width.h"
#include "facenav/core/error.h"
#include "masked_air.h"
#include "measured_part.h"
#include "scalp_edge.h"
#include "scalp_outline.h"
#include "skin_doubt.h"

namespace facenav::surface {
namespace {

constexpr double kVertexSpacing_mm = 1.5;
constexpr double kOutlineBlur_mm = 1.2;

/// The six ends of the grid, at the outermost voxel centres; the mesh ends there too.
std::vector<std::pair<Point<Mri>, Direction<Mri>>> endsOf(const volume::VoxelGrid& grid) {
  std::vector<std::pair<Point<Mri>, Direction<Mri>>> planes;
  const Eigen::Matrix3d across =
      grid.mri_from_voxel.linear().inverse().transpose();  // normals of the index planes
  const Eigen::Vector3d middle = grid.toVoxel(grid.centre());
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      Eigen::Vector3d ijk = middle;
      ijk[axis] = side < 0 ? 0.0 : grid.size[axis] - 1.0;
      planes.emplace_back(grid.toMri(ijk), Direction<Mri>(Eigen::Vector3d(side * across.col(axis))));
    }
  return planes;
}

ScalpSurface scalpOf(const volume::Volume& volume, const volume::Mask& head, TaskMonitor& monitor) {
  monitor.report("scalp", 0.0);
  ScalpSurface scalp;
  scalp.mesh = outlineOf(head, kVertexSpacing_mm, kOutlineBlur_mm);
  if (scalp.mesh.vertices_mm.size() < 1000)
    throw Error("no scalp: the head mask is empty", {}, "redo the head mask");
  const MeshNeighbours neighbours = neighboursOf(scalp.mesh);
  monitor.report("scalp", 0.3);
  const auto unmasked = withoutMaskStep(volume, head);
  const volume::Volume& scan = unmasked ? *unmasked : volume;
  const bool is_erased = unmasked.has_value();
  moveOntoEdge(scalp.mesh, neighbours, scan, {4.0, 3.0, 0.7, 4, 2.0, is_erased});
  monitor.report("scalp", 0.5);
  moveOntoEdge(scalp.mesh, neighbours, scan, {3.0, 3.0, 0.6, 3, 1.0, is_erased});
  monitor.report("scalp", 0.7);
  moveOntoEdge(scalp.mesh, neighbours, scan, {3.0, 3.0, 0.5, 3, 0.7, is_erased});
  scalp.doubt_mm = skinDoubt_mm(scalp.mesh, neighbours, volume, head);
  scalp.field_of_view = endsOf(volume.grid);
  const FaceCheck face =
      checkFace(scalp.mesh, neighbours, scalp.field_of_view, edgeWidth_mm(scalp.mesh, volume));
  scalp.has_face = face.has_face;
  scalp.has_cut_ear = face.has_cut_ear;
  scalp.findings = face.findings;
  monitor.report("scalp", 1.0);
  return scalp;
}

}  // namespace

ScalpSurface extractScalp(const volume::Volume& volume, const volume::Mask& head, TaskMonitor& monitor) {
  if (!volume.grid.matches(head.grid)) throw Error("head mask and volume lie on different grids");
  const auto measured = withoutPadding(volume, head);
  return measured ? scalpOf(measured->scan, measured->head, monitor) : scalpOf(volume, head, monitor);
}

double skinDoubtUnder_mm(const ScalpSurface& scalp, const Point<Mri>& place, double reach_mm) {
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t v = 0; v < scalp.doubt_mm.size(); ++v) {
    if ((scalp.mesh.vertices_mm[v] - place.mm).squaredNorm() > reach_mm * reach_mm) continue;
    squares += std::max(0.0, scalp.doubt_mm[v] * scalp.doubt_mm[v] - kClearSkin_mm * kClearSkin_mm), ++count;
  }
  return count ? std::sqrt(squares / double(count)) : 0.0;
}

}  // namespace facenav::surface
