#include <algorithm>
#include <future>

#include "brain_checks.h"
#include "brain_refinement.h"
#include "brain_start.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"
#include "scan_sharpness.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;
using volume::VoxelGrid;

constexpr double kMargin_mm = 16;  // around the first mask: for the search and for the closing's ball
constexpr double kCore_mm = 4;     // deeper in the first mask there is only brain

constexpr float kMostDoubt_mm = 30;  // where another limit finds no brain
constexpr double kLeastThreshold = 0.3, kSmithsThreshold = 0.5;
constexpr double kSafeShare = 0.8;  // of the first ball: only brain, its fluid and ventricles

/// The part of the grid with the mask, plus a margin.
VoxelGrid gridAround(const Mask& mask, double margin_mm) {
  const auto& n = mask.grid.size;
  std::array<int, 3> low = n, high{-1, -1, -1};
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        if (!mask.at(i, j, k)) continue;
        const std::array<int, 3> at{i, j, k};
        for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], at[a]), high[a] = std::max(high[a], at[a]);
      }
  const int margin = int(margin_mm / mask.grid.spacing_mm().mean());
  VoxelGrid grid = mask.grid;
  for (int a = 0; a < 3; ++a) grid.size[a] = std::max(0, high[a] - low[a] + 1) + 2 * margin;
  grid.mri_from_voxel.translate(Eigen::Vector3d(low[0] - margin, low[1] - margin, low[2] - margin));
  return grid;
}

/// BET uses one median and one threshold for the whole head, so the field must be about even.
Volume withoutRoughBias(const Volume& working) {
  const Volume coarse = halved(working);
  const BrainStart start = findBrainStart(coarse);
  return corrected(working, fitRoughBias(coarse, start.sphere.centre_mm, kSafeShare * start.sphere.radius_mm,
                                         start.intensities.t));
}

/// BET's threshold as a share of white matter, between this scan's own fluid and grey matter. Where grey
/// matter is dark, Smith's 0.5 would stop inside it.
double fractionalThreshold(const TissueModel& tissue, float dark) {
  const double level = 0.5 * (tissue.fluid.mean + tissue.grey.mean);
  return std::clamp((level - dark) / std::max(1e-6, tissue.white.mean - dark), kLeastThreshold,
                    kSmithsThreshold);
}

/// Value of open fluid (ventricles): the darkest fiftieth of the core. The class of fluid is mostly in narrow
/// sulci: its mean rises with the size of the voxels and falls with noise. Where the core has hardly any
/// fluid (its darkest fiftieth is near the class mean), the value is derived from the class: as far below its
/// mean as on 1 mm scans of adults, but brighter than air.
float openFluid(const Volume& flat, const Mask& core, const TissueModel& tissue) {
  constexpr double kDarkest = 0.02;
  constexpr double kBelowClass = 0.54, kLeastOfClass = 0.4;  // per distance to grey matter, per mean
  const double by_class = std::max(tissue.fluid.mean - kBelowClass * (tissue.grey.mean - tissue.fluid.mean),
                                   kLeastOfClass * tissue.fluid.mean);
  std::vector<float> values;
  for (std::size_t v = 0; v < core.voxels.size(); ++v)
    if (core.voxels[v]) values.push_back(flat.voxels[v]);
  if (values.empty()) return float(by_class);
  const float at = selectRank(values, std::size_t(kDarkest * double(values.size())));
  // Between the value from the class and the class mean, from their midpoint on: the value from the class
  // gets more and more weight.
  const double away = (at - by_class) / std::max(1e-6, tissue.fluid.mean - by_class);
  return float(at + (by_class - at) * std::clamp(2 * away - 1, 0.0, 1.0));
}

/// The image in which the surface is searched: blurred so that it shows crowns and thin films of fluid as
/// little as coarse voxels do. The classes are fitted without this blur: where sulci are few, it would remove
/// the class of fluid.
Volume softened(const Volume& image) {
  return volume::spread(image, Eigen::Vector3d::Constant(settingsOf<BrainGrowth>().softening_mm2));
}

/// Thresholds the smoothed mask. The steps of the working grid, which is at an angle to the scan's, would
/// otherwise leave a pattern in the scan's grid.
Mask onGrid(const Mask& brain, const VoxelGrid& grid) {
  const Volume level = volume::smoothed({brain.grid, {brain.voxels.begin(), brain.voxels.end()}, {}, {}});
  Mask out{grid, std::vector<std::uint8_t>(grid.count())};
  const Volume there = volume::resample(level, grid);
  for (std::size_t v = 0; v < out.voxels.size(); ++v) out.voxels[v] = there.voxels[v] >= 0.5f;
  return out;
}

constexpr int kDoubtStep = 2;  // voxels between the places with a stated uncertainty

/// Distance to the surfaces of a stricter and of a more generous limit of tissue: from the mean of the fluid
/// in sulci to the start of grey matter's class. The generous one may also enter sinuses and dura.
std::vector<BoundaryDoubt> doubtsOf(const Mask& brain, const Refinement& refinement,
                                    const BrainGrowth& growth) {
  const auto awayOf = [&](double stricter, double rise) {
    return volume::distanceTo(volume::surfaceVoxels(refinement.brain(stricter, rise)));
  };
  auto strict = std::async(std::launch::async, [&] { return awayOf(growth.strict_share, growth.rise); });
  std::vector<float> furthest = awayOf(-growth.generous_share, growth.generous_rise);
  const std::vector<float> other = strict.get();
  for (std::size_t v = 0; v < furthest.size(); ++v) furthest[v] = std::max(furthest[v], other[v]);
  const Mask surface = volume::surfaceVoxels(brain);
  std::vector<BoundaryDoubt> doubts;
  std::size_t at = 0;
  for (int k = 0; k < brain.grid.size[2]; ++k)
    for (int j = 0; j < brain.grid.size[1]; ++j)
      for (int i = 0; i < brain.grid.size[0]; ++i, ++at)
        if (surface.voxels[at] && (i + j + k) % kDoubtStep == 0)
          doubts.push_back(
              {brain.grid.toMri({double(i), double(j), double(k)}), std::min(furthest[at], kMostDoubt_mm)});
  return doubts;
}

class BrainSegmenter : public Segmenter {
 public:
  SegmentationResult segment(const Volume& volume, TaskMonitor& monitor) const override {
    requireBrainScan(volume);
    monitor.report("looking for the brain", 0);
    const Volume working = withoutRoughBias(workingVolume(volume, 1.0)), coarse = halved(working);
    const BrainStart by_head = findBrainStart(coarse);
    requireTissueSpread(coarse, by_head.sphere);
    // The classes come from the first ball: it includes fluid, which the brain's own ball may lack.
    const TissueModel rough = fitTissue(
        coarse, ballOf(coarse.grid, by_head.sphere.centre_mm, kSafeShare * by_head.sphere.radius_mm));
    BetOptions bet;
    bet.fractional_threshold = fractionalThreshold(rough, by_head.intensities.t2);
    const BrainStart start = centredOnBrain(coarse, by_head, bet.fractional_threshold, monitor);
    const BetSurface surface = evolveBet(coarse, start.sphere, start.intensities, bet, monitor);
    const Mask whole = enclosed(surface, working.grid);
    const VoxelGrid grid = gridAround(whole, kMargin_mm);
    const Mask first = volume::resample(whole, grid);
    const Mask core = erode(first, kCore_mm);
    const Volume image = atCommonSharpness(volume::resample(working, grid), volume.grid, core, rough);
    monitor.report("measuring grey and white matter", 0.6);
    // Without noise, which would widen the fluid's class towards air and lower the limit of tissue.
    const Volume calm = smoothed(image);
    const TissueModel tissue = fitTissue(calm, core, &rough);
    requireTissueContrast(tissue);
    monitor.report("separating the brain", 0.75);
    const Volume rough_flat = corrected(softened(image), tissue), calm_flat = corrected(calm, tissue);
    const float open_fluid = openFluid(calm_flat, core, tissue);
    const Volume flat =
        calmed(rough_flat, noiseOf(rough_flat, calm_flat, core, tissue), tissue.grey.mean - open_fluid);
    const BrainGrowth& growth = settingsOf<BrainGrowth>();
    const Refinement refinement(flat, calm_flat, first, tissue, open_fluid, growth);
    const Mask brain = refinement.brain();
    monitor.report("asking how sure the brain's surface is", 0.85);
    SegmentationResult result;
    result.mask = onGrid(brain, volume.grid);
    result.doubts = doubtsOf(brain, refinement, growth);
    result.warnings = checkBrain(result.mask, by_head.sphere);
    return result;
  }
};

}  // namespace

std::unique_ptr<Segmenter> makeBrainSegmenter() { return std::make_unique<BrainSegmenter>(); }

}  // namespace facenav::segmentation
