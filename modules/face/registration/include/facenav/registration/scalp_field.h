#pragma once
// ScalpField: look-up of the signed distance to the MRI's skin, built once per case and shared by all
// alignments. A coarse grid over head and surroundings serves the search; bricks of a fine one in a band
// around the skin serve the fit. Both are interpolated trilinearly, so that the gradient is that of the
// distance and Gauss-Newton steps are exact. The interpolation error is h^2/8 times the skin's mean
// curvature: under 0.05 mm on the tip of a nose (fine grid). Points without counterpart give NaN: beyond the
// scan's end, and where the nearest skin is its cut edge. Mri mm; positive outside.

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "facenav/registration/field_grids.h"
#include "facenav/registration/skin_model.h"

namespace facenav::registration {

class NearestSkin;

/// Distance and its gradient (close to unit length, outward).
struct FieldSample {
  float distance_mm;  // NaN: no counterpart
  Eigen::Vector3f gradient;
};

class ScalpField {
 public:
  /// Throws Error("not aligned: ...") if the skin has no points, no normals or no triangles.
  explicit ScalpField(const SkinModel& skin);
  /// Reads a file of write() in milliseconds. Null if the file is missing, damaged, of another version or of
  /// another skin.
  static std::shared_ptr<const ScalpField> read(const SkinModel& skin, const std::filesystem::path& path);
  /// Writes the whole file or nothing; mode 0600, little-endian. It is derived data and can always be built
  /// again. Throws Error.
  void write(const std::filesystem::path& path) const;
  ~ScalpField();
  ScalpField(const ScalpField&) = delete;
  ScalpField& operator=(const ScalpField&) = delete;

  /// Coarse grid: error 0.1 mm on a forehead, 0.5 mm on a nose. kFar_mm outside the grid.
  FieldSample coarse(const Eigen::Vector3f& p_mri_mm) const;
  /// Fine grid within about kBand_mm of the skin, the coarse grid beyond.
  FieldSample fine(const Eigen::Vector3f& p_mri_mm) const;
  /// Both grids; valid as long as the field.
  const FieldGrids& grids() const { return grids_; }
  static constexpr float kFar_mm = FieldGrids::kFar_mm, kBand_mm = 3.0f;

  const SkinModel& skin() const { return skin_; }
  const Eigen::Vector3d& low_mm() const { return low_; }
  const Eigen::Vector3d& high_mm() const { return high_; }
  /// Tip of the nose, or the most advanced part of it that the scan contains.
  const Eigen::Vector3d& noseTip_mm() const { return nose_tip_; }
  Eigen::Vector3d middle_mm() const { return 0.5 * (low_ + high_); }
  /// The mesh behind the grids, for methods that pair points with vertices: exact but slower. Built at the
  /// first call.
  const NearestSkin& nearest() const;

 private:
  using Brick = std::array<float, FieldGrids::kBrickNodes>;

  struct Unfilled {};
  ScalpField(const SkinModel& skin, Unfilled);
  bool fillFrom(const std::string& content);
  void fillCoarse();
  void fillBricks();
  void showGrids();
  float nodeDistance_mm(const Eigen::Vector3d& p_mri_mm) const;

  SkinModel skin_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const NearestSkin> nearest_;
  Eigen::Vector3d low_, high_, nose_tip_;
  Eigen::Vector3f origin_;
  std::array<int, 3> coarse_size_{}, brick_size_{};
  std::vector<float> coarse_;
  std::vector<std::int32_t> brick_at_;
  std::vector<Brick> bricks_;
  FieldGrids grids_;
};

/// Reads the field of `skin` from the file `path`. If the file is missing or of another skin, the field is
/// built and, if the folder allows, written there. Nothing is written with an empty path. Throws Error as
/// ScalpField.
std::shared_ptr<const ScalpField> keptScalpField(const SkinModel& skin, const std::filesystem::path& path);

inline FieldSample interpolate(const float* c, int sy, int sz, const Eigen::Vector3f& at, float spacing_mm) {
  const float x = at.x(), y = at.y(), z = at.z();
  const float dx00 = c[1] - c[0], dx10 = c[sy + 1] - c[sy], dx01 = c[sz + 1] - c[sz],
              dx11 = c[sy + sz + 1] - c[sy + sz];
  const float a00 = c[0] + x * dx00, a10 = c[sy] + x * dx10, a01 = c[sz] + x * dx01,
              a11 = c[sy + sz] + x * dx11;
  const float dy0 = a10 - a00, dy1 = a11 - a01;
  const float b0 = a00 + y * dy0, b1 = a01 + y * dy1;
  const float inverse = 1.0f / spacing_mm;
  const float gx = (dx00 + y * (dx10 - dx00)) + z * ((dx01 + y * (dx11 - dx01)) - (dx00 + y * (dx10 - dx00)));
  return {b0 + z * (b1 - b0),
          Eigen::Vector3f(gx * inverse, (dy0 + z * (dy1 - dy0)) * inverse, (b1 - b0) * inverse)};
}

inline FieldSample sampleCoarse(const FieldGrids& grids, const Eigen::Vector3f& p) {
  const Eigen::Vector3f at =
      (p - Eigen::Map<const Eigen::Vector3f>(grids.origin_mm)) * (1.0f / FieldGrids::kCoarse_mm);
  const int* size = grids.coarse_size;
  // This form treats a NaN position as outside.
  if (!(at.x() >= 0.0f && at.y() >= 0.0f && at.z() >= 0.0f && at.x() < float(size[0] - 1) &&
        at.y() < float(size[1] - 1) && at.z() < float(size[2] - 1)))
    return {FieldGrids::kFar_mm, Eigen::Vector3f::UnitZ()};
  const int i = int(at.x()), j = int(at.y()), k = int(at.z());
  const int sy = size[0], sz = size[0] * size[1];
  return interpolate(grids.coarse + std::size_t(i) + std::size_t(sy) * j + std::size_t(sz) * k, sy, sz,
                     {at.x() - float(i), at.y() - float(j), at.z() - float(k)}, FieldGrids::kCoarse_mm);
}

inline FieldSample sampleFine(const FieldGrids& grids, const Eigen::Vector3f& p) {
  const Eigen::Vector3f at =
      (p - Eigen::Map<const Eigen::Vector3f>(grids.origin_mm)) * (1.0f / FieldGrids::kFine_mm);
  const int* size = grids.brick_size;
  if (!(at.x() >= 0.0f && at.y() >= 0.0f && at.z() >= 0.0f && at.x() < FieldGrids::kFar_mm &&
        at.y() < FieldGrids::kFar_mm && at.z() < FieldGrids::kFar_mm))
    return {FieldGrids::kFar_mm, Eigen::Vector3f::UnitZ()};
  const int i = int(at.x()), j = int(at.y()), k = int(at.z());
  const int a = i / FieldGrids::kBrick, b = j / FieldGrids::kBrick, c = k / FieldGrids::kBrick;
  if (a >= size[0] || b >= size[1] || c >= size[2]) return sampleCoarse(grids, p);
  const std::int32_t brick =
      grids.brick_at[std::size_t(a) + std::size_t(size[0]) * (b + std::size_t(size[1]) * c)];
  if (brick < 0) return sampleCoarse(grids, p);
  const int node =
      (i - a * FieldGrids::kBrick) +
      FieldGrids::kSide * ((j - b * FieldGrids::kBrick) + FieldGrids::kSide * (k - c * FieldGrids::kBrick));
  return interpolate(grids.bricks + std::size_t(brick) * FieldGrids::kBrickNodes + std::size_t(node),
                     FieldGrids::kSide, FieldGrids::kSide * FieldGrids::kSide,
                     {at.x() - float(i), at.y() - float(j), at.z() - float(k)}, FieldGrids::kFine_mm);
}

inline FieldSample ScalpField::coarse(const Eigen::Vector3f& p) const { return sampleCoarse(grids_, p); }
inline FieldSample ScalpField::fine(const Eigen::Vector3f& p) const { return sampleFine(grids_, p); }

}  // namespace facenav::registration
