#pragma once
// The ball case with all that the electric field's three shells need: a brain of 70 mm and its cortex.

#include "facenav/surface/cortex_surface.h"
#include "support/ball_case.h"

namespace facenav::testing {

inline casefile::PreparedCase ballWithCortex() {
  auto prepared = ballCase();
  volume::Mask brain = prepared.head_mask;
  for (int k = 0; k < 50; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 50; ++i)
        brain.voxels[brain.grid.index(i, j, k)] = brain.grid.toMri(Eigen::Vector3d(i, j, k)).mm.norm() < 70;
  TaskMonitor monitor;
  prepared.brain = surface::buildBrainModel(prepared.mri, brain, {}, monitor);
  prepared.cortex.emplace();
  prepared.cortex->mesh = surface::extractCortex(brain, {4.0, 0}, monitor);
  prepared.cortex->distance_mm.assign(prepared.cortex->mesh.vertices_mm.size(), 0.f);
  prepared.brain_mask = std::move(brain);
  return prepared;
}

}  // namespace facenav::testing
