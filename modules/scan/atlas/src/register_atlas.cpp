#include "facenav/atlas/register_atlas.h"

#include "affine_fit.h"
#include "demons.h"
#include "facenav/geometry/rotation.h"

namespace facenav::atlas {
namespace {

constexpr double kAffineCoarse_mm = 8.0, kAffineFine_mm = 4.0;

/// Heads may be tilted in the scanner. So several pitch angles are tried for a few steps, and the best one is
/// refined.
Eigen::Affine3d coarseAffine(const BrainPair& pair, TaskMonitor& monitor) {
  const Eigen::Affine3d upright = affineFromMoments(pair);
  const Eigen::Vector3d centre_mm = pair.templateMoments().centre_mm;
  Eigen::Affine3d best = upright;
  double best_cost = HUGE_VAL;
  for (const double pitch_deg : {0.0, -20.0, 20.0, -40.0, 40.0}) {
    monitor.report("registering the atlas", 0.02);
    const Eigen::AngleAxisd pitch(pitch_deg * kRadPerDeg, Eigen::Vector3d::UnitX());
    const Eigen::Affine3d start =
        upright * Eigen::Translation3d(centre_mm) * pitch * Eigen::Translation3d(-centre_mm);
    const Eigen::Affine3d fit = fitAffine(pair, start, 15);
    const double fit_cost = cost(pair, pair.warped(fit, nullptr));
    if (fit_cost >= best_cost) continue;
    best_cost = fit_cost;
    best = fit;
  }
  return best;
}

std::vector<Eigen::Vector3f> inMillimetres(const VectorField& displacement, double spacing_mm) {
  std::vector<Eigen::Vector3f> displacement_mm(displacement[0].values.size());
  for (std::size_t n = 0; n < displacement_mm.size(); ++n)
    for (int a = 0; a < 3; ++a) displacement_mm[n][a] = float(spacing_mm) * displacement[a].values[n];
  return displacement_mm;
}

}  // namespace

AtlasFit registerAtlas(const volume::Volume& mri, const volume::Mask& brain, const BrainTemplate& atlas,
                       const AtlasOptions& options, TaskMonitor& monitor) {
  const char* kStep = "registering the atlas";
  monitor.report(kStep, 0.0);
  const BrainImages images(atlas.brain, mri, brain, options.spacing_mm);
  const BrainPair coarsest(images, kAffineCoarse_mm);
  Eigen::Affine3d affine = coarseAffine(coarsest, monitor);
  monitor.report(kStep, 0.05);
  affine = fitAffine(BrainPair(images, kAffineFine_mm), affine, 25);
  monitor.report(kStep, 0.1);
  auto displacement =
      runDemons(coarsest, affine, noDisplacement(coarsest.grid().size), options.iterations_coarse,
                [&](double part) { monitor.report(kStep, 0.1 + 0.05 * part); });
  const BrainPair middle(images, 2 * options.spacing_mm);
  displacement =
      runDemons(middle, affine, onGrid(displacement, coarsest.grid(), middle.grid()),
                options.iterations_coarse, [&](double part) { monitor.report(kStep, 0.15 + 0.25 * part); });
  const BrainPair fine(images, options.spacing_mm);
  displacement =
      runDemons(fine, affine, onGrid(displacement, middle.grid(), fine.grid()), options.iterations_fine,
                [&](double part) { monitor.report(kStep, 0.4 + 0.6 * part); });
  const Channels moving = fine.warped(affine, &displacement);
  const AtlasQuality quality{fine.correlation(fine.warped(affine, nullptr)), fine.correlation(moving),
                             fine.dice(moving), smallestJacobian(displacement)};
  return {AtlasMap(affine, fine.grid(), inMillimetres(displacement, options.spacing_mm)), quality};
}

}  // namespace facenav::atlas
