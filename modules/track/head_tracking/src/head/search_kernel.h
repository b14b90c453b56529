#pragma once
// The inner loops of the search for a lost face (coarse_search.h, face_template.h, skin_detail.h): images
// evened against light, correlation of a stencil at every place, one step of the template's fit, patches
// decomposed into patterns. Compiled twice (facenav/core/simd.h).

#include <cstdint>

namespace facenav::head_tracking::search {

constexpr int kLanes = 8;    // results computed at once
constexpr int kWindow = 11;  // window's side, over which light is evened
constexpr int kRim = kWindow / 2;

/// Each pixel's deviation from the mean of the window about it, divided by the root sum of squares of the
/// window's standard deviation and the least contrast. `from`: BlurredImage with a rim of kRim pixels, pixel
/// (0, 0) is the rim's corner; `scratch`: 6 * (columns + kWindow + kLanes) values.
struct Evening {
  const std::uint16_t* from = nullptr;
  int from_stride = 0, columns = 0, rows = 0;  // size of the result
  float least_contrast = 0.f, per_mean = 0.f;  // grey levels; and per mean grey
  std::int32_t* scratch = nullptr;
  float* to = nullptr;
  int to_stride = 0;
};

/// sums(y, x) = sum over i of value[i] * from[i][y * stride + x], for whole blocks of kLanes columns.
struct Correlation {
  const float* const* from = nullptr;
  const float* value = nullptr;
  int count = 0, stride = 0, columns = 0, rows = 0;  // columns: a multiple of kLanes
  float* sums = nullptr;                             // rows x columns
};

/// The grey values of one placed patch, bilinear. `count`: a multiple of kLanes.
struct Sampling {
  const std::uint16_t* pixels = nullptr;  // as in BlurredImage
  int stride = 0, left = 0, top = 0, width = 0, height = 0;
  const float *x = nullptr, *y = nullptr, *z = nullptr;  // Head, mm
  int count = 0;
  float camera_T_head[12] = {0};      // rotation, row by row, then translation
  float d[4] = {0}, offset[2] = {0};  // as in patch::Placement
  float* to = nullptr;
};

/// to[i][p] = sum over k of patterns[k][p] * values[i][k], for `count` rows of values.
struct Expansion {
  static constexpr int kPatterns = 5 * kLanes;
  const float* patterns = nullptr;  // length x kPatterns
  const float* values = nullptr;    // count x length
  int length = 0, count = 0;
  float* to = nullptr;  // count x kPatterns
};

/// The points of a template for one camera, kLanes side by side: blocks of kFields x kLanes.
struct TemplateField {
  enum : int { x, y, z, normal_x, normal_y, normal_z, value, weight, d00, d01, d10, d11, u0, v0, count };
};

struct TemplateView {
  const float* blocks = nullptr;  // pixel = d (x/z, y/z) + (u0, v0); weight 0: no point
  int block_count = 0;
  const float* image = nullptr;
  int stride = 0, width = 0, height = 0;
  float camera_T_head[12] = {0};  // rotation, row by row, then translation
  float centre[3] = {0};          // centre of rotation of the increments, Head
  float least_facing = 0.f, reach = 1.f;
};

/// Weighted sums over the points: J'J (upper triangle, row by row), J'e, and of the measured and expected
/// grey values.
struct TemplateSums {
  float normal[21] = {0}, pull[6] = {0};
  float product = 0.f, now_squares = 0.f, then_squares = 0.f, seen = 0.f;
};

struct Kernel {
  void (*even)(const Evening&);
  void (*correlate)(const Correlation&);
  bool (*sample)(const Sampling&);  // false if a sample lies outside
  void (*expand)(const Expansion&);
  TemplateSums (*sum)(const TemplateView&);
};

const Kernel& baseKernel();
const Kernel& avx2Kernel();
/// Returns the fastest version for this processor.
const Kernel& kernel();

}  // namespace facenav::head_tracking::search
