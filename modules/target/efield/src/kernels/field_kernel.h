#pragma once
// The inner loops of the field solver, for plain arrays. Compiled twice (facenav/core/simd.h); the two differ
// by rounding alone. Lengths in mm.

#include <cstddef>
#include <cstdint>

namespace facenav::efield::kernels {

constexpr int kTileRows = 16, kTileColumns = 6;  // part of a product that is summed in registers
constexpr int kLanes = 16;                       // points that are worked on together
constexpr int kBlock = 32;                       // rows of a packed matrix that lie side by side
constexpr int kCorners = 6;                      // places at which a far triangle is sampled

/// Adds packed a times packed b to a tile of c.
struct TileTask {
  std::ptrdiff_t depth;
  const float* a;  // [depth][kTileRows]
  const float* b;  // [depth][kTileColumns]
  float* c;
  std::ptrdiff_t column_step;
  int rows, columns;  // of c, at most a tile
};

/// Points in three arrays; `count` is a multiple of kLanes.
struct Points {
  const float *x, *y, *z;
  std::ptrdiff_t count;
};

/// Sum over dipoles of m x (p - q) / |p - q|^3 at each point p.
struct DipoleTask {
  Points points;
  const float *q, *m;  // [dipoles][3]
  int dipoles;
  float *x, *y, *z;  // results, `count` each
};

/// (p - r) / |p - r|^3 at each point p, for one place r.
struct PullTask {
  Points points;
  float r[3];
  float *x, *y, *z;
};

/// A triangle seen from afar: its solid angle, shared out among its corners.
struct FarTriangle {
  float at[kCorners][3];      // sampled places
  float across[3];            // normal times area
  float centre[3], reach_mm;  // nearer than `reach_mm` to the centre it is not far
  std::int32_t corner[3];     // numbers of its vertices
};
/// Adds to sums[corner][lane] for kLanes places at once.
struct FarTask {
  const float *x, *y, *z;  // kLanes places
  const FarTriangle* triangles;
  std::ptrdiff_t count;
  const float (*shares)[3];  // [kCorners][3]: weight of a sampled place times its share of each corner
  float* sums;               // [vertices][kLanes]
  std::uint16_t* near;       // bit of each lane that sees a triangle from near; nothing was added for it
};

/// out = packed matrix times `in`; the matrix is [blocks][columns][kBlock].
struct ExpandTask {
  std::ptrdiff_t blocks, columns;
  const float* in;
  float* out;  // [blocks][kBlock]
};

struct Kernel {
  void (*tile)(const TileTask& task);
  void (*dipoles)(const DipoleTask& task);
  void (*pull)(const PullTask& task);
  void (*far)(const FarTask& task);
  void (*expandFloats)(const ExpandTask& task, const float* matrix);
  void (*expandShorts)(const ExpandTask& task, const std::int16_t* matrix);
};

Kernel baseKernel();
Kernel avx2Kernel();
/// The fastest kernel that this processor runs.
const Kernel& kernel();

}  // namespace facenav::efield::kernels
