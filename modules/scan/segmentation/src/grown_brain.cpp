#include "grown_brain.h"

#include <algorithm>
#include <future>
#include <utility>

#include "brain_checks.h"
#include "brain_refinement.h"
#include "brain_start.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "facenav/volume/smoothing.h"
#include "scan_grid.h"
#include "scan_sharpness.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;
using volume::VoxelGrid;

constexpr double kMargin_mm = 16;  // around the first mask: room for the search and for the closing's ball

constexpr float kMostDoubt_mm = 30;  // doubt where another limit finds no brain at all
constexpr double kLeastThreshold = 0.3, kSmithsThreshold = 0.5;
constexpr double kSafeShare = 0.8;  // of the first ball: only brain, its fluid and ventricles
constexpr float kAirShare = 0.1f;   // share of the brain's median below which is air

/// BET's threshold as a share of white matter, set between this scan's own fluid and grey matter: if grey
/// matter is dark, Smith's 0.5 would stop inside it.
double fractionalThreshold(const TissueModel& tissue, float dark) {
  const double level = 0.5 * (tissue.fluid.mean + tissue.grey.mean);
  return std::clamp((level - dark) / std::max(1e-6, tissue.white.mean - dark), kLeastThreshold,
                    kSmithsThreshold);
}

/// The value of fluid in wide spaces (ventricles): the darkest fiftieth of the core. The fluid's class lies
/// mostly in narrow sulci; it becomes brighter with larger voxels and darker with noise. It is used only if
/// the core contains next to no fluid (the darkest fiftieth is near the class' mean): the value is then as
/// far below the class as on 1 mm scans of adults, yet brighter than air.
float openFluid(const Volume& flat, const Mask& core, const TissueModel& tissue) {
  constexpr double kDarkest = 0.02;
  constexpr double kBelowClass = 0.54, kLeastOfClass = 0.4;  // of the distance to grey matter, of the mean
  const double by_class = std::max(tissue.fluid.mean - kBelowClass * (tissue.grey.mean - tissue.fluid.mean),
                                   kLeastOfClass * tissue.fluid.mean);
  std::vector<float> values;
  for (std::size_t v = 0; v < core.voxels.size(); ++v)
    if (core.voxels[v]) values.push_back(flat.voxels[v]);
  if (values.empty()) return float(by_class);
  const float at = selectRank(values, std::size_t(kDarkest * double(values.size())));
  // From halfway between both on, the weight of the class increases.
  const double away = (at - by_class) / std::max(1e-6, tissue.fluid.mean - by_class);
  return float(at + (by_class - at) * std::clamp(2 * away - 1, 0.0, 1.0));
}

/// The image for the search of the surface: its crowns and thin films of fluid are as blurred as in coarse
/// voxels. The classes are fitted without this blur: where sulci are few, the class of fluid would be lost.
Volume softened(Volume image) {
  return volume::spread(std::move(image), Eigen::Vector3d::Constant(settingsOf<BrainGrowth>().softening_mm2));
}

constexpr int kDoubtStep = 2;  // voxels between the places where doubt is given

/// Doubt of the surface: distance to the surfaces of a stricter and a more generous limit of tissue, from the
/// mean of the fluid in sulci to where grey matter's class begins. The generous one may also pass into
/// sinuses and dura.
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

/// Limit of air: a share of the median in the ball, which fluid and air hardly change.
float airLimit(const Volume& coarse, const BetSphere& sphere) {
  const Mask ball = ballOf(coarse.grid, sphere.centre_mm, kSafeShare * sphere.radius_mm);
  std::vector<float> values;
  for (std::size_t v = 0; v < ball.voxels.size(); ++v)
    if (ball.voxels[v]) values.push_back(coarse.voxels[v]);
  return values.empty() ? 0.f : kAirShare * upperMedian(std::move(values));
}

}  // namespace

GrowthStart startFromHead(const Volume& working, TaskMonitor& monitor) {
  GrowthStart out;
  {  // BET uses one median and threshold for the whole head, so the bias must be about even.
    const Volume coarse = halved(working);
    const BrainStart start = findBrainStart(coarse);
    out.working = corrected(working, fitRoughBias(coarse, start.sphere.centre_mm,
                                                  kSafeShare * start.sphere.radius_mm, start.intensities.t));
  }
  const Volume coarse = halved(out.working);
  const BrainStart by_head = findBrainStart(coarse);
  requireTissueSpread(coarse, by_head.sphere);
  out.sphere = by_head.sphere;
  // The classes from the first ball, which reaches into fluid; the brain's own mask may contain none.
  out.rough =
      fitTissue(coarse, ballOf(coarse.grid, by_head.sphere.centre_mm, kSafeShare * by_head.sphere.radius_mm));
  BetOptions bet;
  bet.fractional_threshold = fractionalThreshold(out.rough, by_head.intensities.t2);
  const BrainStart start = centredOnBrain(coarse, by_head, bet.fractional_threshold, monitor);
  const Mask whole = enclosed(evolveBet(coarse, start.sphere, start.intensities, bet, monitor), working.grid);
  out.first = volume::resample(whole, partAround(whole, kMargin_mm));
  out.search_mm = settingsOf<BrainGrowth>().search_mm;
  return out;
}

GrowthStart startFromOutline(const Volume& working, const Mask& outline, double search_mm) {
  GrowthStart out;
  const Ball ball = ballLike(outline);
  out.sphere = {ball.centre_mm, ball.radius_mm};
  const Volume coarse = halved(working);
  out.working = corrected(working, fitRoughBias(coarse, ball.centre_mm, kSafeShare * ball.radius_mm,
                                                airLimit(coarse, out.sphere)));
  out.rough =
      fitTissue(halved(out.working), ballOf(coarse.grid, ball.centre_mm, kSafeShare * ball.radius_mm));
  out.first = volume::resample(outline, partAround(outline, kMargin_mm));
  out.search_mm = search_mm;
  return out;
}

std::optional<GrownBrain> growBrain(GrowthStart start, const VoxelGrid& scan, TaskMonitor& monitor,
                                    const std::function<bool(const Mask&)>& isWanted) {
  const VoxelGrid& grid = start.first.grid;
  const Mask core = erode(start.first, start.core_mm);
  Volume image = volume::resample(std::exchange(start.working, {}), grid);
  image = atCommonSharpness(image, scan, core, start.rough);
  monitor.report("measuring grey and white matter", 0.6);
  // Removes the voxels' noise, which would spread the fluid's class down into air and with it the limit of
  // tissue.
  Volume calm = smoothed(image);
  const TissueModel tissue = fitTissue(calm, core, &start.rough);
  requireTissueContrast(tissue);
  monitor.report("separating the brain", 0.75);
  const Volume calm_flat = corrected(std::exchange(calm, {}), tissue);
  Volume flat = corrected(softened(std::exchange(image, {})), tissue);
  const float open_fluid = openFluid(calm_flat, core, tissue);
  flat = calmed(flat, noiseOf(flat, calm_flat, core, tissue), tissue.grey.mean - open_fluid);
  BrainGrowth growth = settingsOf<BrainGrowth>();
  growth.search_mm = start.search_mm;
  const Refinement refinement(flat, calm_flat, start.first, tissue, open_fluid, growth);
  GrownBrain out;
  out.mask = refinement.brain();
  if (!isWanted(out.mask)) return std::nullopt;
  monitor.report("asking how sure the brain's surface is", 0.85);
  out.doubts = doubtsOf(out.mask, refinement, growth);
  return out;
}

}  // namespace facenav::segmentation
