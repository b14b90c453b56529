#include "contrast_seen.h"

#include <vector>

#include "facenav/core/robust_statistics.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/smoothing.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr float kRim_mm = 5, kDeep_mm = 10, kDeepest_mm = 25;
constexpr int kShadingPasses = 60;             // passes of 1-2-1 on 2 mm: sigma 11 mm
constexpr float kBrain = 0.5f, kFluid = 0.4f;  // low, since few voxels of 4 mm contain fluid alone
constexpr double kBrightFluid = 1.15;
constexpr double kWhiteAboveGrey = 1.02, kFluidBelowGrey = 0.95, kInverted = 0.98;
// Largest ratio of fluid to rim in a clear T1, fitted. Above it a T1 counts as weak and gets a little more
// doubt (stated_doubt.cpp): the safe direction is down.
constexpr double kClearlyDarkFluid = 0.73;

double medianOf(std::vector<float> values) { return values.empty() ? 0 : upperMedian(std::move(values)); }

/// Local mean of the values within the brain.
Volume shadingOf(const Volume& image, const Mask& brain) {
  Volume sum = image, weight = image;
  for (std::size_t v = 0; v < brain.voxels.size(); ++v) {
    weight.voxels[v] = brain.voxels[v];
    sum.voxels[v] = brain.voxels[v] ? image.voxels[v] : 0;
  }
  for (int pass = 0; pass < kShadingPasses; ++pass)
    sum = volume::smoothed(std::move(sum)), weight = volume::smoothed(std::move(weight));
  for (std::size_t v = 0; v < sum.voxels.size(); ++v) sum.voxels[v] /= weight.voxels[v] + 1e-3f;
  return sum;
}

}  // namespace

bool ContrastSeen::isLikeT1() const {
  return deep_to_rim > kWhiteAboveGrey && fluid_to_rim < kFluidBelowGrey;
}

bool ContrastSeen::isInverted() const { return deep_to_rim < kInverted; }

ContrastKind ContrastSeen::kind() const {
  if (isLikeT1()) return fluid_to_rim < kClearlyDarkFluid ? ContrastKind::t1 : ContrastKind::weak_t1;
  if (fluid_to_rim > kBrightFluid) return ContrastKind::t2;
  return fluid_to_rim < kFluidBelowGrey ? ContrastKind::flair : ContrastKind::proton_density;
}

std::string ContrastSeen::inWords() const {
  switch (kind()) {
    case ContrastKind::t1:
      return "T1";
    case ContrastKind::weak_t1:
      return "T1 (weak: fluid is not much darker than grey matter)";
    case ContrastKind::t2:
      return "T2 (fluid is brighter than the brain)";
    case ContrastKind::flair:
      return "FLAIR (white matter is darker than grey, fluid is dark)";
    case ContrastKind::proton_density:
      return "proton density (fluid and brain are alike)";
  }
  return "";
}

ContrastSeen contrastSeen(const Volume& coarse, const Volume& brain, const Volume& fluid) {
  Mask inside{brain.grid, std::vector<std::uint8_t>(brain.voxels.size())};
  for (std::size_t v = 0; v < inside.voxels.size(); ++v) inside.voxels[v] = brain.voxels[v] >= kBrain;
  const std::vector<float> depth_mm = volume::depthWithin(inside);
  const Volume shading = shadingOf(coarse, inside);
  std::vector<float> rim, deep, around;
  for (std::size_t v = 0; v < inside.voxels.size(); ++v) {
    const float local = shading.voxels[v];
    if (!(local > 0)) continue;
    const float value = coarse.voxels[v] / local;
    if (fluid.voxels[v] >= kFluid) around.push_back(value);
    if (inside.voxels[v] && depth_mm[v] < kRim_mm) rim.push_back(value);
    if (inside.voxels[v] && depth_mm[v] > kDeep_mm && depth_mm[v] < kDeepest_mm) deep.push_back(value);
  }
  const double rim_value = medianOf(std::move(rim));
  if (!(rim_value > 0)) return {};
  return {medianOf(std::move(deep)) / rim_value, medianOf(std::move(around)) / rim_value};
}

}  // namespace facenav::segmentation
