#pragma once
// A small case made of balls about the origin: fast to create, with known results.

#include "facenav/casefile/case_store.h"
#include "facenav/surface/brain_model.h"
#include "support/ball_mesh.h"

namespace facenav::testing {

/// Case with skin at 90 mm, grey inside; no brain.
inline casefile::PreparedCase ballCase() {
  casefile::PreparedCase prepared;
  auto& grid = prepared.mri.grid;
  grid.size = {50, 50, 50};
  grid.mri_from_voxel.linear() *= 4.0;
  grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-98.0);
  for (int k = 0; k < 50; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 50; ++i) {
        const double r = grid.toMri(Eigen::Vector3d(i, j, k)).mm.norm();
        prepared.mri.voxels.push_back(r < 90 ? 160.f : 0.f);
        prepared.head_mask.voxels.push_back(r < 90);
      }
  prepared.head_mask.grid = grid;
  prepared.scalp.mesh = ballMesh(90.0);
  prepared.scalp.has_face = true;
  prepared.findings = {"no brain model: a ball has none"};
  return prepared;
}

/// The ball case with a brain of 40 mm inside it.
inline casefile::PreparedCase ballWithBrain() {
  auto prepared = ballCase();
  volume::Mask brain = prepared.head_mask;
  for (int k = 0; k < 50; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 50; ++i)
        brain.voxels[brain.grid.index(i, j, k)] = brain.grid.toMri(Eigen::Vector3d(i, j, k)).mm.norm() < 40.0;
  TaskMonitor monitor;
  prepared.brain = surface::buildBrainModel(prepared.mri, brain, {}, monitor);
  prepared.brain_mask = std::move(brain);
  return prepared;
}

}  // namespace facenav::testing
