#pragma once
// A small prepared case: an oblique 20 x 24 x 18 grid with a ball for a head and a smaller one for a brain.

#include "facenav/casefile/case_store.h"

namespace facenav::casefile::testing {

inline volume::VoxelGrid obliqueGrid() {
  volume::VoxelGrid grid;
  grid.size = {20, 24, 18};
  grid.mri_from_voxel.linear() = Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 2, 3).normalized()) *
                                 Eigen::DiagonalMatrix<double, 3>(1.5, 1.0, 2.0).toDenseMatrix();
  grid.mri_from_voxel.translation() << -13, 21.5, -40;
  return grid;
}

inline volume::Mask ball(double radius_mm) {
  volume::Mask mask{obliqueGrid(), {}};
  const Eigen::Vector3d centre_mm = mask.grid.centre().mm;
  for (int k = 0; k < mask.grid.size[2]; ++k)
    for (int j = 0; j < mask.grid.size[1]; ++j)
      for (int i = 0; i < mask.grid.size[0]; ++i)
        mask.voxels.push_back((mask.grid.mri_from_voxel * Eigen::Vector3d(i, j, k) - centre_mm).norm() <
                              radius_mm);
  return mask;
}

/// Octahedron about the grid's centre.
inline surface::TriangleMesh octahedron(double radius_mm) {
  surface::TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      mesh.normals.push_back(sign * Eigen::Vector3d::Unit(axis));
      mesh.vertices_mm.push_back(obliqueGrid().centre().mm + radius_mm * mesh.normals.back());
    }
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return mesh;
}

inline PreparedCase preparedCase() {
  PreparedCase prepared;
  prepared.mri.grid = obliqueGrid();
  for (std::size_t i = 0; i < prepared.mri.grid.count(); ++i) prepared.mri.voxels.push_back(float(i % 1000));
  prepared.mri.modality = "MR";
  prepared.mri.orientation_source = "DICOM";
  prepared.head_mask = ball(11);
  prepared.brain_mask = ball(7);
  prepared.scalp.mesh = octahedron(11);
  prepared.scalp.has_face = true;
  prepared.scalp.findings = {"nose tip cut by the scan's edge"};
  prepared.brain = surface::BrainModel{};
  prepared.brain->mesh = octahedron(7);
  prepared.brain->texture_coordinates.assign(6, Eigen::Vector2f(0.25f, 0.75f));
  auto& map = prepared.brain->map;
  map.rows = map.columns = 12;
  map.centre = obliqueGrid().centre();
  map.radius_mm.assign(144, 7.0);
  map.colour.assign(144, 90);
  prepared.findings = {"the face was removed below the brow"};
  return prepared;
}

inline PreparedCase withoutBrain() {
  PreparedCase prepared = preparedCase();
  prepared.brain_mask.reset();
  prepared.brain.reset();
  return prepared;
}

inline std::vector<Provenance> provenance() {
  return {{"prepare", "0.1.0", {{"head", "threshold"}}, {{"mri", std::string(64, 'a')}}}};
}

inline guidance::TreatmentPlan onePlan() {
  guidance::TreatmentPlan plan;
  guidance::Target target;
  target.name = "M1 hand L";
  target.cortex_point = Point<Mri>(-37, -21, 58);
  plan.targets = {target};
  return plan;
}

}  // namespace facenav::casefile::testing
