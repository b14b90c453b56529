#include "facenav/surface/scan_quality.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <vector>

#include "facenav/core/robust_statistics.h"
#include "scalp/measured_part.h"

namespace facenav::surface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr const char* kNames[3][2] = {{"left", "right"}, {"back", "front"}, {"bottom", "top"}};
constexpr const char* kDirections[3] = {"left-right", "front-back", "up-down"};

constexpr std::size_t kEnoughAir = 200;  // fewest voxels of air
/// Least overlap (Dice) of the tissue at front and back of a head that wraps around: 0.21 to 0.98 in
/// fold-overs of 5 to 40 mm of five heads. Without a cut there is none.
constexpr double kAlike = 0.2;
/// Least share of a side's tissue that lies in line with the cut opposite, where a program cropped the scan
/// after it was folded: then the piece is smaller than the cut. 0.92 and more in two heads cropped by 6 mm.
constexpr double kWithin = 0.6;
constexpr double kTouch_mm2 = 30;  // as for cut sides

/// Voxels of air, without erased ones.
struct AirSum {
  double square = 0, plain = 0;
  std::size_t count = 0, negative = 0;
  void add(double value) { square += value * value, plain += value, ++count, negative += value < 0; }
  double mean() const { return plain / double(count); }
};

class ScanMeter {
 public:
  ScanMeter(const volume::Volume& mri, const volume::Mask& head, const TriangleMesh& scalp)
      : mri_(mri), head_(head), scalp_(scalp), grid_(mri.grid) {}

  ScanQuality measure() {
    quality_.largest_voxel_mm = grid_.spacing_mm().maxCoeff();
    quality_.smallest_voxel_mm = grid_.spacing_mm().minCoeff();
    measureSkin();
    findShadows();
    measureAir();
    measureSides();
    return quality_;
  }

 private:
  /// The patient's axis nearest to voxel axis `axis`, and whether it is reversed.
  std::pair<int, bool> patientAxis(int axis) const {
    const Vector3d along = grid_.mri_from_voxel.linear().col(axis);
    int patient = 0;
    along.cwiseAbs().maxCoeff(&patient);
    return {patient, along[patient] < 0};
  }

  /// Profile from air to skin along the normals: height of the step and its steepest millimetre.
  void measureSkin() {
    constexpr double kOutside_mm = 5, kInside_mm = 5, kEvery_mm = 0.5;
    constexpr std::size_t kSamples = 3000;
    std::vector<double> steps, slopes;
    const std::size_t stride = std::max<std::size_t>(1, scalp_.vertices_mm.size() / kSamples);
    for (std::size_t v = 0; v < scalp_.vertices_mm.size(); v += stride) {
      double outside = 0, highest = 0, before = 0, slope = 0;
      for (double t = kOutside_mm; t >= -kInside_mm; t -= kEvery_mm) {
        const double value = volume::sampleLinear(
            mri_, grid_.toVoxel(Point<Mri>(scalp_.vertices_mm[v] + t * scalp_.normals[v])));
        if (t == kOutside_mm) outside = before = value;
        slope = std::max(slope, (value - before) / kEvery_mm);
        highest = std::max(highest, value);
        before = value;
      }
      if (highest > outside) steps.push_back(highest - outside), slopes.push_back(slope);
    }
    quality_.skin_step = upperMedian(steps);
    slope_per_mm_ = upperMedian(slopes);
  }

  /// Finds, per axis, the lines of voxels that meet the head (or come within `gap` voxels of it).
  void findShadows() {
    gap_ = int(std::ceil(8 / quality_.smallest_voxel_mm));  // outside the skin's own blur
    for (int axis = 0; axis < 3; ++axis) {
      shadow_[std::size_t(axis)].assign(
          std::size_t(grid_.size[std::size_t(across(axis))]) * grid_.size[std::size_t(along(axis))], 0);
      first_[std::size_t(axis)].assign(shadow_[std::size_t(axis)].size(), INT_MAX);
      last_[std::size_t(axis)].assign(shadow_[std::size_t(axis)].size(), INT_MIN);
    }
    for (int k = 0; k < grid_.size[2]; ++k)
      for (int j = 0; j < grid_.size[1]; ++j)
        for (int i = 0; i < grid_.size[0]; ++i)
          if (head_.at(i, j, k)) markShadows({i, j, k});
    for (int axis = 0; axis < 3; ++axis) dilateShadow(axis);
  }

  static int across(int axis) { return (axis + 1) % 3; }
  static int along(int axis) { return (axis + 2) % 3; }
  std::size_t line(int axis, const Vector3i& p) const {
    return std::size_t(p[across(axis)]) + std::size_t(grid_.size[std::size_t(across(axis))]) * p[along(axis)];
  }

  void markShadows(const Vector3i& p) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t at = line(axis, p), a = std::size_t(axis);
      shadow_[a][at] = 1;
      first_[a][at] = std::min(first_[a][at], p[axis]);
      last_[a][at] = std::max(last_[a][at], p[axis]);
    }
  }

  void dilateShadow(int axis) {
    const int width = grid_.size[std::size_t(across(axis))], height = grid_.size[std::size_t(along(axis))];
    auto& shadow = shadow_[std::size_t(axis)];
    for (const bool is_row : {true, false}) {
      const auto in = shadow;
      for (int v = 0; v < height; ++v)
        for (int u = 0; u < width; ++u)
          for (int k = -gap_; k <= gap_; ++k) {
            const int s = is_row ? u + k : u, t = is_row ? v : v + k;
            if (s >= 0 && t >= 0 && s < width && t < height && in[std::size_t(s) + std::size_t(width) * t])
              shadow[std::size_t(u) + std::size_t(width) * v] = 1;
          }
    }
  }

  /// Air on lines that do not meet the head along any axis contains noise only. Ghosts are copies of the head
  /// along the phase-encoding axis, so they lie on lines along that axis.
  void measureAir() {
    AirSum corners;
    std::array<AirSum, 3> beside;
    std::size_t erased = 0;
    for (int k = 0; k < grid_.size[2]; k += 2)
      for (int j = 0; j < grid_.size[1]; j += 2)
        for (int i = 0; i < grid_.size[0]; i += 2) {
          const Vector3i p(i, j, k);
          int joined = 0, axis = -1;
          for (int a = 0; a < 3; ++a)
            if (shadow_[std::size_t(a)][line(a, p)]) ++joined, axis = a;
          if (joined > 1 || (joined == 1 && !isBeyond(axis, p))) continue;
          if (isErased(p))
            ++erased;
          else
            (joined == 1 ? beside[std::size_t(axis)] : corners).add(mri_.at(i, j, k));
        }
    judgeNoise(corners, erased);
    judgeGhosts(corners, beside);
  }

  /// Measures ghosts in magnitude images only: CT shows table and headrest beside the head, and signed ghosts
  /// cancel out in a mean.
  void judgeGhosts(const AirSum& corners, const std::array<AirSum, 3>& beside) {
    if (quality_.noise <= 0 || quality_.skin_step <= 0 || quality_.is_air_signed) return;
    for (int axis = 0; axis < 3; ++axis) {
      const AirSum& air = beside[std::size_t(axis)];
      if (air.count < kEnoughAir) continue;
      quality_.has_ghost_measure = true;
      const double share = (air.mean() - corners.mean()) / quality_.skin_step;
      if (share > quality_.ghost_share)
        quality_.ghost_share = share, quality_.ghost_direction = kDirections[patientAxis(axis).first];
    }
  }

  /// True if the value equals its neighbours': filled in by a program (rotated or defaced scans), not
  /// measured.
  bool isErased(const Vector3i& p) const {
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Vector3i q = p;
        q[axis] += step;
        if (grid_.contains(q[0], q[1], q[2]) && mri_.at(q[0], q[1], q[2]) != mri_.at(p[0], p[1], p[2]))
          return false;
      }
    return true;
  }

  /// True before or behind all of the head on its line, by more than the gap.
  bool isBeyond(int axis, const Vector3i& p) const {
    const std::size_t at = line(axis, p), a = std::size_t(axis);
    return first_[a][at] == INT_MAX || p[axis] < first_[a][at] - gap_ || p[axis] > last_[a][at] + gap_;
  }

  /// Measures noise. Magnitude images: the air is Rayleigh distributed, so its mean square is twice the
  /// variance of the signal (Gudbjartsson and Patz 1995). Signed values: the standard deviation.
  void judgeNoise(const AirSum& air, std::size_t erased) {
    quality_.is_air_blanked = air.count < kEnoughAir && erased >= kEnoughAir;
    if (air.count < kEnoughAir) return;
    quality_.is_air_signed = isSigned(air);
    const double square = air.square / double(air.count);
    const double variance = std::max(0.0, square - air.mean() * air.mean());
    quality_.noise = std::sqrt(quality_.is_air_signed ? variance : square / 2);
    if (slope_per_mm_ > 0) quality_.skin_jitter_mm = quality_.noise / slope_per_mm_;
  }

  /// True if the values are signed. A few negative voxels come from interpolation: the air of such an MR is
  /// that of a magnitude image.
  bool isSigned(const AirSum& air) const {
    constexpr double kMostNegative = 0.05, kClearly = 0.1;  // share of the voxels; share of the skin's step
    return mri_.modality == "CT" || double(air.negative) > kMostNegative * double(air.count) ||
           air.mean() < -kClearly * quality_.skin_step;
  }

  void measureSides() {
    const auto measured = withoutPadding(mri_, head_);
    for (int axis = 0; axis < 3; ++axis)
      for (int end = 0; end < 2; ++end)
        measureSide(measured ? measured->scan : mri_, measured ? measured->head : head_, axis, end);
  }

  /// Examines the outermost measured slice of one side. Head in that slice is cut by the scan. Tissue there
  /// that is not part of the head and lies in line with a cut on the opposite side has wrapped around. Front
  /// and back of a head are unlike: there, tissue in line counts also where it joined the head.
  void measureSide(const volume::Volume& mri, const volume::Mask& head, int axis, int end) {
    const auto [patient, is_reversed] = patientAxis(axis);
    ScanSide& side = quality_.sides[std::size_t(2 * patient + (end ^ int(is_reversed)))];
    side.name = kNames[patient][end ^ int(is_reversed)];
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto& size = mri.grid.size;
    const Vector3d spacing = grid_.spacing_mm();
    std::size_t cut = 0, cut_opposite = 0, free_in_line = 0, in_line = 0, tissue = 0;
    Vector3i here, there;
    here[axis] = end ? size[std::size_t(axis)] - 1 : 0;
    there[axis] = end ? 0 : size[std::size_t(axis)] - 1;
    for (here[u] = 0; here[u] < size[std::size_t(u)]; ++here[u])
      for (here[v] = 0; here[v] < size[std::size_t(v)]; ++here[v]) {
        there[u] = here[u], there[v] = here[v];
        const bool is_cut = head.at(here[0], here[1], here[2]);
        const bool is_tissue = is_cut || mri.at(here[0], here[1], here[2]) > tissueLevel();
        cut += is_cut, tissue += is_tissue;
        if (!head.at(there[0], there[1], there[2])) continue;
        ++cut_opposite;
        in_line += is_tissue;
        free_in_line += is_tissue && !is_cut;
      }
    side.cut_area_mm2 = double(cut) * spacing[u] * spacing[v];
    if (cut_opposite <= 20) return;
    side.wrapped_share = double(free_in_line) / double(cut_opposite);
    if (patient != 1 || double(in_line) * spacing[u] * spacing[v] < kTouch_mm2) return;
    const double likeness = 2.0 * double(in_line) / double(tissue + cut_opposite);
    const double within = double(in_line) / double(tissue);
    side.is_wrapped = likeness > kAlike || within > kWithin;
    if (side.is_wrapped) side.wrapped_share = double(in_line) / double(cut_opposite);
  }

  double tissueLevel() const { return std::max(0.3 * quality_.skin_step, 6 * quality_.noise); }

  const volume::Volume& mri_;
  const volume::Mask& head_;
  const TriangleMesh& scalp_;
  const volume::VoxelGrid& grid_;
  ScanQuality quality_;
  double slope_per_mm_ = 0;
  int gap_ = 0;
  std::array<std::vector<char>, 3> shadow_;
  std::array<std::vector<int>, 3> first_, last_;  // first and last voxel of the head on each line
};

}  // namespace

ScanQuality measureScan(const volume::Volume& mri, const volume::Mask& head, const TriangleMesh& scalp) {
  return ScanMeter(mri, head, scalp).measure();
}

}  // namespace facenav::surface
