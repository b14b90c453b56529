#pragma once
// The inner loops of the fit. Points of the cloud are placed in the MRI by a pose and looked up in the
// scalp's distance field; then the sums of a Gauss-Newton step are formed. Compiled twice
// (facenav/core/simd.h); the two differ by rounding only.

#include "facenav/registration/field_grids.h"

namespace facenav::registration::point {

constexpr int kBlock = 128;                // number of points processed together; a multiple of 8
constexpr float kGrazing_cos = 0.12f;      // skin at a flatter angle to the view has no counterpart
constexpr float kNormalsAgree_cos = 0.3f;  // cloud normals are noisy: only large disagreement excludes
constexpr float kNoSkin_mm = 1e5f;         // larger distances and NaN have no counterpart

/// The cloud, one array per coordinate, Camera mm. The length is a whole number of blocks, padded with NaN.
struct Points {
  const float* at_mm[3] = {nullptr, nullptr, nullptr};
  const float* normal[3] = {nullptr, nullptr, nullptr};  // may be null
  const float* weight = nullptr;                         // null: all 1
};

/// mri_T_camera in single precision; t is also the camera's position in Mri.
struct View {
  float r[3][3], t[3];
};

struct Block {
  int count = 0;
  float at_mm[3][kBlock], normal[3][kBlock], residual_mm[kBlock];  // in Mri
  float is_valid[kBlock];                                          // 1 or 0
};

/// Residuals beyond `inside_mm` (behind the skin) or `outside_mm` have no weight. Rotations are about the
/// pivot (Mri).
struct Loss {
  float inside_mm, outside_mm, pivot_mm[3];
};

/// Sums of one block: the lower triangle, row by row, of the weighted 7 x 7 products of (turn, normal,
/// residual), and the sum of the weights.
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
/// Returns the fastest version for this processor.
const Kernel& kernel();

}  // namespace facenav::registration::point
