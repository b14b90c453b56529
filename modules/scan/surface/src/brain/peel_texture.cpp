#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/surface/detailed_cortex.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"

namespace facenav::surface {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using volume::Mask;
using volume::Volume;

constexpr double kHull_mm = 2.0;    // grid of the depth below the hull
constexpr int kSmoothings = 3;      // of that depth: keeps the inward direction the same at each gyrus
constexpr double kMargin_mm = 6.0;  // margin of MRI around the brain
constexpr double kBelow = 0.05, kAbove = 0.98;  // percentiles of the brain's values at the ends of the window

Volume depthBelowHull(const Mask& brain) {
  const Mask coarse = volume::resample(brain, volume::gridAround(brain, kHull_mm, kMargin_mm));
  const auto inside_mm = volume::depthWithin(coarse), outside_mm = volume::distanceTo(coarse);
  Volume depth{coarse.grid, std::vector<float>(coarse.voxels.size()), {}, {}};
  for (std::size_t v = 0; v < depth.voxels.size(); ++v) depth.voxels[v] = inside_mm[v] - outside_mm[v];
  for (int pass = 0; pass < kSmoothings; ++pass) depth = volume::smoothed(std::move(depth));
  return depth;
}

/// Unit vector, Mri: direction of increasing depth, or towards the middle when the depth is constant.
Vector3d inwardsAt(const Volume& depth, const Vector3d& p_mm) {
  const Vector3d at = depth.grid.toVoxel(Point<Mri>(p_mm));
  Vector3d slope;
  for (int a = 0; a < 3; ++a)
    slope[a] = volume::sampleLinear(depth, at + Vector3d::Unit(a)) -
               volume::sampleLinear(depth, at - Vector3d::Unit(a));
  if (slope.norm() < 0.2) slope = depth.grid.centre().mm - p_mm;  // the grid is axis-parallel
  return slope.norm() > 0 ? Vector3d(slope.normalized()) : Vector3d(-Vector3d::UnitZ());
}

std::pair<float, float> windowOf(const Volume& mri, const Mask& brain) {
  std::vector<float> values;
  for (std::size_t v = 0; v < mri.voxels.size(); v += 5)
    if (brain.voxels[v]) values.push_back(mri.voxels[v]);
  if (values.empty()) throw Error("the brain mask is empty", {}, "segment the brain, or paint it");
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) { return values[std::size_t(share * double(values.size() - 1))]; };
  return {at(kBelow), std::max(at(kAbove), at(kBelow) + 1e-6f)};
}

}  // namespace

PeelTexture::PeelTexture(const Volume& mri, const Mask& brain, const TriangleMesh& surface) {
  const auto grid = volume::gridAround(brain, mri.grid.spacing_mm().minCoeff(), kMargin_mm);
  mri_ = volume::resample(mri, grid);
  std::tie(low_, high_) = windowOf(mri_, volume::resample(brain, grid));
  const Volume depth = depthBelowHull(brain);
  const double per_mm = 1 / grid.spacing_mm().x();
  at_.resize(surface.vertices_mm.size()), step_.resize(at_.size());
  vtkSMPTools::For(0, vtkIdType(at_.size()), [&](vtkIdType begin, vtkIdType end) {
    for (auto v = std::size_t(begin); v < std::size_t(end); ++v) {
      const Vector3d& p = surface.vertices_mm[v];
      at_[v] = (per_mm * (p - grid.mri_from_voxel.translation())).cast<float>();
      step_[v] = (per_mm * inwardsAt(depth, p)).cast<float>();
    }
  });
}

std::vector<std::uint8_t> PeelTexture::greyAt(double depth_mm) const {
  std::vector<std::uint8_t> grey(at_.size());
  const float scale = 255 / (high_ - low_);
  vtkSMPTools::For(0, vtkIdType(at_.size()), [&](vtkIdType begin, vtkIdType end) {
    for (auto v = std::size_t(begin); v < std::size_t(end); ++v) {
      const Vector3f p = at_[v] + float(depth_mm) * step_[v];
      const float value = volume::sampleLinear(mri_, p.cast<double>(), low_);
      grey[v] = std::uint8_t(std::lround(std::clamp((value - low_) * scale, 0.f, 255.f)));
    }
  });
  return grey;
}

}  // namespace facenav::surface
