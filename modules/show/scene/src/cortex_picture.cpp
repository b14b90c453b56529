#include "facenav/scene/cortex_picture.h"

#include <algorithm>
#include <cmath>

#include "coarse_mesh.h"

namespace facenav::scene {
namespace {

constexpr double kCoarse_mm = 3.2, kLeastScale_mm = 2.0;

}  // namespace

CortexPicture makeCortexPicture(const volume::Volume& mri, const volume::Mask& brain,
                                surface::DetailedCortex cortex, TaskMonitor& monitor) {
  monitor.report("sampling below the surface", 0.0);
  auto coarse_mesh = coarsened(cortex.mesh, kCoarse_mm);
  surface::PeelTexture coarse_peel(mri, brain, coarse_mesh);
  monitor.report("sampling below the surface", 0.3);
  surface::PeelTexture peel(mri, brain, cortex.mesh);
  monitor.report("sampling below the surface", 1.0);
  const auto distance = surface::summarise(cortex.distance_mm);
  const double full_mm = distanceScale_mm(distance);
  auto coarse_distance_mm = valuesAtNearest(cortex.mesh, cortex.distance_mm, coarse_mesh);
  return {std::move(cortex),
          std::move(peel),
          std::move(coarse_mesh),
          std::move(coarse_peel),
          std::move(coarse_distance_mm),
          distance,
          full_mm};
}

double distanceScale_mm(const surface::SurfaceDistance& distance) {
  return std::max(kLeastScale_mm, std::ceil(distance.p95_mm));
}

palette::Rgb distanceColour(double signed_mm, double full_mm) {
  constexpr palette::Rgb kZero{0.93, 0.94, 0.95}, kInside{0.10, 0.42, 0.86};
  const palette::Rgb& end = signed_mm > 0 ? palette::kOrange : kInside;
  const double share = std::clamp(std::abs(signed_mm) / full_mm, 0.0, 1.0);
  palette::Rgb colour{};
  for (std::size_t i = 0; i < 3; ++i) colour[i] = kZero[i] + share * (end[i] - kZero[i]);
  return colour;
}

}  // namespace facenav::scene
