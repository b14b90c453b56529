#include "brain_checks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "facenav/anatomy/brain_norms.h"
#include "facenav/anatomy/head_norms.h"
#include "facenav/core/error.h"
#include "facenav/volume/regrid.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;

constexpr double kLeastContrast = 0.06;  // (white - grey) / white; T1 MR has 0.2 to 0.4, CT below 0.02
constexpr double kThickSlice_mm = 3;
constexpr double kCutArea_mm2 = 100;   // area of the brain in the scan's outermost slice
constexpr double kMiddle = 0.6;        // radius, as a share of the brain's ball
constexpr double kLeastSpread = 0.06;  // 20th to 80th percentile, divided by the median

[[noreturn]] void noBrain(const std::string& reason) {
  throw Error("no brain can be modelled: " + reason, {}, "a T1-weighted MR of the whole head is needed");
}

std::string millilitres(double ml) { return std::to_string(int(std::lround(ml))) + " ml"; }

double mostVolume_ml(const BetSphere& by_head) {
  const double ball_ml = 4.0 / 3 * M_PI * std::pow(by_head.radius_mm, 3) * 1e-3;
  return std::clamp(anatomy::kBrainPerHeadBall.high * ball_ml, anatomy::kPossibleBrain.high,
                    anatomy::kLargestBrain.high);
}

/// Area of the mask in the outermost slice of each side of the grid (RAS order): left, right, back, front,
/// bottom, top.
std::array<double, 6> areaAtEdges_mm2(const Mask& brain) {
  const Mask ras = volume::toRasOrder(brain);
  const auto& n = ras.grid.size;
  const Eigen::Vector3d h = ras.grid.spacing_mm();
  std::array<double, 6> area{};
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        const bool is_edge = i == 0 || j == 0 || k == 0 || i == n[0] - 1 || j == n[1] - 1 || k == n[2] - 1;
        if (!is_edge || !ras.at(i, j, k)) continue;
        const std::array<int, 3> at{i, j, k};
        for (int a = 0; a < 3; ++a) {
          const double pixel_mm2 = h.prod() / h[a];
          if (at[a] == 0) area[2 * a] += pixel_mm2;
          if (at[a] == n[a] - 1) area[2 * a + 1] += pixel_mm2;
        }
      }
  return area;
}

}  // namespace

void requireMr(const volume::Volume& volume) {
  if (volume.modality == "CT") noBrain("this is a CT, in which grey and white matter look alike");
}

void requireBrainScan(const volume::Volume& volume) {
  const Eigen::Vector3d h = volume.grid.spacing_mm();
  for (int a = 0; a < 3; ++a)
    if (volume.grid.size[a] * h[a] < anatomy::kScanOfBrain.low)
      noBrain("the scan covers only " + std::to_string(int(volume.grid.size[a] * h[a])) +
              " mm in one direction");
}

void requireTissueContrast(const TissueModel& tissue) {
  if (!(tissue.contrast() >= kLeastContrast)) noBrain("grey and white matter do not differ in this scan");
}

void requireTissueSpread(const volume::Volume& coarse, const BetSphere& sphere) {
  const Mask ball = ballOf(coarse.grid, sphere.centre_mm, kMiddle * sphere.radius_mm);
  std::vector<float> values;
  for (std::size_t v = 0; v < ball.voxels.size(); ++v)
    if (ball.voxels[v]) values.push_back(coarse.voxels[v]);
  if (values.empty()) noBrain("there is no head in this volume");
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return double(values[std::size_t(share * double(values.size() - 1))]);
  };
  if (at(0.8) - at(0.2) < kLeastSpread * at(0.5))
    noBrain("the tissues within the head all look alike, as on a CT");
}

std::vector<std::string> checkBrain(const Mask& brain, const BetSphere& by_head) {
  const double ml = brain.volume_ml(), most_ml = mostVolume_ml(by_head);
  if (ml < anatomy::kPossibleBrain.low || ml > most_ml)
    noBrain("what looks like a brain measures " + millilitres(ml) + " (" +
            std::to_string(int(anatomy::kPossibleBrain.low)) + " to " +
            std::to_string(int(std::lround(most_ml))) + " is possible in this head)");
  std::vector<std::string> warnings;
  constexpr std::array<const char*, 6> kSides{"left", "right", "back", "front", "bottom", "top"};
  const auto area = areaAtEdges_mm2(brain);
  for (int side = 0; side < 6; ++side)
    if (area[side] > kCutArea_mm2)
      warnings.push_back(std::string("the brain is cut by the scan's edge at the ") + kSides[side]);
  if (brain.grid.spacing_mm().maxCoeff() > kThickSlice_mm)
    warnings.push_back("the slices are thicker than 3 mm: the brain's surface is coarse");
  return warnings;
}

}  // namespace facenav::segmentation
