#include "facenav/evaluation/skin_additions.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/evaluation/volume_perturbation.h"
#include "facenav/surface/closest_point.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/smoothing.h"

namespace facenav::evaluation {
namespace {

using Eigen::Vector3d;
using volume::Mask;
using volume::Volume;

constexpr double kHaloFull_mm = 3.5, kHaloEnd_mm = 6;
constexpr double kNoseReach_mm = 30;
constexpr float kExact_mm = 4;    // distance to the skin up to which distances are exact
constexpr double kBlur_mm = 0.6;  // blur of scans of 1 mm

/// Calls visit(index, place) for every voxel.
template <class Visit>
void forPlaces(const volume::VoxelGrid& grid, Visit&& visit) {
  std::size_t v = 0;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i, ++v) visit(v, grid.toMri({double(i), double(j), double(k)}).mm);
}

/// Extent of the head above the ears, and its nose.
struct HeadExtent {
  double top_mm = -1e9;
  Vector3d low_mm = Vector3d::Constant(1e9), high_mm = Vector3d::Constant(-1e9), nose_mm{0, -1e9, 0};

  explicit HeadExtent(const Mask& head) {
    forPlaces(head.grid, [&](std::size_t v, const Vector3d& p) {
      if (head.voxels[v]) top_mm = std::max(top_mm, p.z());
    });
    if (top_mm < -1e8) throw Error("the head mask is empty");
    forPlaces(head.grid, [&](std::size_t v, const Vector3d& p) {
      if (head.voxels[v] && p.z() > top_mm - 90) low_mm = low_mm.cwiseMin(p), high_mm = high_mm.cwiseMax(p);
    });
    forPlaces(head.grid, [&](std::size_t v, const Vector3d& p) {
      if (head.voxels[v] && p.z() > top_mm - 160 && std::abs(p.x() - middle().x()) < 25 &&
          p.y() > nose_mm.y())
        nose_mm = p;
    });
  }
  Vector3d middle() const { return 0.5 * (low_mm + high_mm); }
  double halfWidth_mm() const { return 0.5 * (high_mm.x() - low_mm.x()); }
};

/// Sum of waves with lengths of some 20 mm, distributed about normally.
class Texture {
 public:
  explicit Texture(std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> phase(0, 2 * M_PI);
    for (int w = 0; w < 6; ++w) {
      waves_.emplace_back(normal(random), normal(random), normal(random));
      phases_.push_back(phase(random));
    }
  }
  double operator()(const Vector3d& p_mm) const {
    double sum = 0;
    for (std::size_t w = 0; w < waves_.size(); ++w) sum += std::sin(waves_[w].dot(p_mm) / 8 + phases_[w]);
    return sum / std::sqrt(3.0);
  }

 private:
  std::vector<Vector3d> waves_;
  std::vector<double> phases_;
};

bool isInPadBehind(const HeadExtent& head, const Vector3d& p) {
  const Vector3d q = p - head.middle();
  return std::abs(q.x()) < 55 && p.y() > head.low_mm.y() - 20 && p.y() < head.low_mm.y() + 30 &&
         p.z() < head.top_mm - 45 && p.z() > head.top_mm - 135;
}

bool isInPadBeside(const HeadExtent& head, const Vector3d& p) {
  const Vector3d q = p - head.middle();
  const double beside = std::abs(q.x());
  return beside > head.halfWidth_mm() - 30 && beside < head.halfWidth_mm() + 14 && std::abs(q.y()) < 35 &&
         p.z() < head.top_mm - 40 && p.z() > head.top_mm - 110;
}

/// Returns true inside a hollow cup over an ear: a rim and a plate.
bool isInEarphone(const HeadExtent& head, const Vector3d& p) {
  const Vector3d q = p - head.middle();
  const double beside = std::abs(q.x()) - head.halfWidth_mm();
  const double from_axis = std::hypot(q.y() + 5, p.z() - (head.top_mm - 120));
  const bool is_rim = from_axis < 40 && from_axis > 30, is_plate = from_axis < 40 && beside > 20;
  return beside > -25 && beside < 26 && (is_rim || is_plate);
}

/// Returns true inside a strip across the forehead, 25 mm high.
bool isInTape(const HeadExtent& head, const Vector3d& p, double away_mm) {
  constexpr double kThick_mm = 1, kHalfLength_mm = 40;
  const Vector3d q = p - head.middle();
  return away_mm > 0 && away_mm < kThick_mm && q.y() > 0 && std::abs(q.x()) < kHalfLength_mm &&
         p.z() < head.top_mm - 45 && p.z() > head.top_mm - 70;
}

float skinSignal(const Volume& volume, const std::vector<float>& away_mm) {
  std::vector<float> values;
  for (std::size_t v = 0; v < away_mm.size(); ++v)
    if (away_mm[v] < -1.5f && away_mm[v] > -5) values.push_back(volume.voxels[v]);
  return values.empty() ? 0.f : upperMedian(std::move(values));
}

/// Distances from the skin, > 0 outside. Exact near the skin, whole voxels further away.
std::vector<float> awayFromSkin_mm(const Mask& head, const surface::TriangleMesh& skin) {
  const surface::ClosestPoint closest(skin);
  std::vector<float> away_mm = volume::distanceTo(head);
  const std::vector<float> depth_mm = volume::depthWithin(head);
  for (std::size_t v = 0; v < away_mm.size(); ++v) away_mm[v] -= depth_mm[v];
  forPlaces(head.grid, [&](std::size_t v, const Vector3d& p) {
    if (std::abs(away_mm[v]) > kExact_mm) return;
    const auto nearest = closest.nearest(Point<Mri>(p));
    away_mm[v] = float(nearest.is_outside ? nearest.distance_mm : -nearest.distance_mm);
  });
  return away_mm;
}

/// Returns true if the air was set to one value.
bool isErased(const Volume& volume, const std::vector<float>& away_mm) {
  std::vector<float> outside;
  for (std::size_t v = 0; v < away_mm.size(); ++v)
    if (away_mm[v] > 3 && away_mm[v] < 25) outside.push_back(volume.voxels[v]);
  if (outside.empty()) return false;
  const float air = upperMedian(outside);
  return 2 * std::count(outside.begin(), outside.end(), air) > std::ptrdiff_t(outside.size());
}

/// Share of air that the scan's blur leaves at this distance from the skin.
double airShare(double away_mm) { return 0.5 * std::erfc(-away_mm / (kBlur_mm * std::sqrt(2.0))); }

double haloAt(const HeadExtent& extent, const Vector3d& p, double away_mm) {
  const double fall = std::clamp((kHaloEnd_mm - away_mm) / (kHaloEnd_mm - kHaloFull_mm), 0.0, 1.0);
  const Vector3d from = (p - extent.middle()).normalized();
  return fall * std::clamp(0.6 + 0.6 * std::max(from.y(), from.z()), 0.3, 1.0);
}

double padAt(const HeadExtent& extent, const SkinAddition& addition, const Vector3d& p) {
  double level = 0;
  if (isInPadBehind(extent, p)) level = addition.pad_behind;
  if (isInPadBeside(extent, p)) level = std::max(level, addition.pads_beside);
  if (isInEarphone(extent, p)) level = std::max(level, addition.earphones);
  return level;
}

void brighten(Volume& scan, const Vector3d& nose_mm, double by) {
  forPlaces(scan.grid, [&](std::size_t v, const Vector3d& p) {
    const double away = (p - nose_mm).norm() / kNoseReach_mm;
    scan.voxels[v] *= float(1 + by * std::exp(-0.5 * away * away));
  });
}

}  // namespace

std::vector<SkinAddition> skinAdditions() {
  std::vector<SkinAddition> all(9);
  all[0].name = "shading 40 %", all[0].shading = 0.4;
  all[1].name = "nose twice as bright", all[1].bright_nose = 1;
  all[2].name = "halo 12 %", all[2].halo = 0.12;
  all[3].name = "halo 20 %", all[3].halo = 0.20;
  all[4].name = "pad behind", all[4].pad_behind = 0.45;
  all[5].name = "pads beside", all[5].pads_beside = 0.3;
  all[6].name = "earphones", all[6].earphones = 0.5;
  all[7].name = "tape", all[7].tape = 0.5;
  all[8] = {"all of them", 0.4, 0.5, 0.12, 0.6, 0.4, 0.4, 0.5};
  return all;
}

CleanScan::CleanScan(const Volume& volume, const Mask& head, const surface::TriangleMesh& skin)
    : volume_(volume), head_(head), away_mm_(awayFromSkin_mm(head, skin)) {
  skin_ = skinSignal(volume, away_mm_);
  is_air_erased_ = isErased(volume, away_mm_);
}

AddedScan CleanScan::with(const SkinAddition& addition, unsigned seed) const {
  std::mt19937 random(seed);
  const HeadExtent extent(head_);
  const Texture texture(random), gaps(random);
  AddedScan out{volume_, {head_.grid, std::vector<std::uint8_t>(head_.voxels.size())}};
  Volume pads{head_.grid, std::vector<float>(head_.voxels.size()), {}, {}};
  forPlaces(head_.grid, [&](std::size_t v, const Vector3d& p) {
    const double away = away_mm_[v];
    if (away < -2) return;
    if (!isAirErased())
      out.scan.voxels[v] +=
          float(addition.halo * haloAt(extent, p, away) * skin_ * airShare(away) * (1 + 0.2 * texture(p)));
    const bool is_tape = addition.tape > 0 && isInTape(extent, p, away);
    const double level = is_tape ? addition.tape : padAt(extent, addition, p);
    if (level <= 0 || (!is_tape && away < std::max(0.3, 0.8 + 0.8 * gaps(p)))) return;
    pads.voxels[v] = float(level * skin_ * (1 + 0.15 * texture(p)));
    out.pads.voxels[v] = 1;
  });
  pads = volume::smoothed(std::move(pads));
  for (std::size_t v = 0; v < pads.voxels.size(); ++v)
    if (pads.voxels[v] > 0) out.scan.voxels[v] += pads.voxels[v] * float(airShare(away_mm_[v]));
  if (addition.bright_nose > 0) brighten(out.scan, extent.nose_mm, addition.bright_nose);
  VolumePerturbation shading;
  shading.bias = addition.shading;
  if (addition.shading > 0) out.scan = perturbed(out.scan, head_, shading, seed);
  return out;
}

}  // namespace facenav::evaluation
