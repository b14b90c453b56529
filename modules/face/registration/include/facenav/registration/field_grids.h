#pragma once
// FieldGrids: ScalpField's two grids as raw arrays, for kernels that read many points at once. It uses no
// library, so that files compiled for one kind of processor only can include it. Mri mm.

#include <cstdint>

namespace facenav::registration {

struct FieldGrids {
  static constexpr float kCoarse_mm = 4.0f, kFine_mm = 1.25f;
  static constexpr int kBrick = 4, kSide = kBrick + 1;  // cells and nodes along a brick
  static constexpr int kBrickNodes = kSide * kSide * kSide;
  static constexpr float kFar_mm = 1e6f;  // value outside the coarse grid

  float origin_mm[3] = {0, 0, 0};
  int coarse_size[3] = {0, 0, 0};          // in nodes
  int brick_size[3] = {0, 0, 0};           // in bricks
  const float* coarse = nullptr;           // x fastest
  const std::int32_t* brick_at = nullptr;  // number of each brick; -1: no brick, the coarse grid is used
  const float* bricks = nullptr;           // kBrickNodes each, x fastest
};

}  // namespace facenav::registration
