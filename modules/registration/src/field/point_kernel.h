#pragma once
// The inner loops of the fit: points of the cloud, placed in the MRI by a pose, looked up in the scalp's
// distance field, and the sums of a Gauss-Newton step. Compiled twice
// (facenav/core/simd.h); the two differ by rounding alone.

#include "facenav/registration/field_grids.h"

namespace facenav::registration::point {

constexpr int kBlock = 128;                // points measured side by side; a multiple of 8
constexpr float kGrazing_cos = 0.12f;      // skin seen flatter than this is no counterpart
constexpr float kNormalsAgree_cos = 0.3f;  // cloud normals are noisy: only gross disagreement counts
constexpr float kNoSkin_mm = 1e5f;         // distances beyond, and those that are no number: no counterpart

/// The cloud, an array a coordinate, Camera mm, as long as a whole number of blocks (filled up with values
/// that are no number).
struct Points {
  const float* at_mm[3] = {nullptr, nullptr, nullptr};
  const float* normal[3] = {nullptr, nullptr, nullptr};  // null: none
  const float* weight = nullptr;                         // null: all 1
};

/// mri_T_camera in single precision; t is also where the camera stands, Mri.
struct View {
  float r[3][3], t[3];
};

struct Block {
  int count = 0;
  float at_mm[3][kBlock], normal[3][kBlock], residual_mm[kBlock];  // Mri
  float is_valid[kBlock];                                          // 1 or 0
};

/// Residuals beyond `inside_mm` (behind the skin) or `outside_mm` have no weight; rotations turn about the
/// pivot (Mri).
struct Loss {
  float inside_mm, outside_mm, pivot_mm[3];
};

/// Of one block: the lower triangle, row by row, of the 7 x 7 products of (turn, normal, residual), weighted;
/// and the sum of the weights.
struct Sums {
  float products[28];
  float weight;
};

struct Kernel {
  /// Points `first` .. `first + count - 1`, count <= kBlock; `first` is a multiple of kBlock.
  void (*measure)(const FieldGrids& grids, const Points& points, int first, int count, const View& view,
                  bool is_fine, Block& block);
  Sums (*sum)(const Block& block, const Points& points, int first, const Loss& loss);
};

const Kernel& baseKernel();
const Kernel& avx2Kernel();
/// The fastest that this processor runs.
const Kernel& kernel();

}  // namespace facenav::registration::point
