#include "brain_start.h"

#include <algorithm>
#include <cmath>

#include "facenav/anatomy/head_norms.h"
#include "facenav/core/error.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "scan_grid.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;
using volume::VoxelGrid;

constexpr double kPad_mm = 6;          // margin around the scan, so that nothing touches the border
constexpr double kFine = 0.95;         // share of the working spacing
constexpr double kTopArea_mm2 = 2500;  // a slice this large is head, not hair or noise
constexpr double kGirthFrom_mm = 100,
                 kGirthTo_mm = 20;  // below the top: slices that give girth and centre
constexpr double kRoundness = 0.98,
                 kBrainShare = 0.81;  // per girth: height of the centre, radius of the brain's ball
constexpr double kRobust = 0.98, kRobustInHead = 0.95;  // the same value where a head fills 0.4 of its scan
constexpr float kHeadShare = 0.1f;  // share of the robust maximum that is brighter than air
constexpr double kSkull_mm = 6;     // closes the skull where the scalp over it is missing
constexpr int kRoughIterations = 400, kRoughSubdivisions = 3;  // for the surface that only places the ball
constexpr double kBallInBrain_mm = 20;                         // wider than leaks, narrower than the brain
constexpr double kSkullShare = 1.2,
                 kDarkest = 0.03;  // radius of the region in brain radii; share of its values

[[noreturn]] void noBrain(const std::string& reason) {
  throw Error("no brain can be modelled: " + reason, {}, "a T1-weighted MR of the whole head is needed");
}

struct Slices {
  std::vector<double> area_mm2;
  std::vector<Eigen::Vector2d> centre;  // voxels
};

Slices sliceAreas(const Mask& head) {
  const auto& n = head.grid.size;
  const double pixel_mm2 = std::pow(head.grid.spacing_mm().mean(), 2);
  Slices s{std::vector<double>(n[2]), std::vector<Eigen::Vector2d>(n[2], Eigen::Vector2d::Zero())};
  for (int k = 0; k < n[2]; ++k) {
    std::size_t count = 0;
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        if (head.at(i, j, k)) ++count, s.centre[k] += Eigen::Vector2d(i, j);
    if (count) s.centre[k] /= double(count);
    s.area_mm2[k] = double(count) * pixel_mm2;
  }
  return s;
}

Mask headOf(const Volume& working, float threshold) {
  Mask head{working.grid, std::vector<std::uint8_t>(working.voxels.size())};
  for (std::size_t v = 0; v < head.voxels.size(); ++v) head.voxels[v] = working.voxels[v] > threshold;
  return largestPart(open(head, 3.0));
}

/// BET's robust maximum, taken in the head alone: over the whole scan it would depend on the amount of air.
/// The head's threshold depends on this maximum in turn; two rounds are enough.
float robustMaximum(const Volume& working) {
  float bright = volume::percentile(working, kRobust);
  for (int round = 0; round < 2; ++round) {
    std::vector<float> head;
    for (const float value : working.voxels)
      if (value > kHeadShare * bright) head.push_back(value);
    if (head.empty()) return bright;
    bright = selectRank(head, std::size_t(kRobustInHead * double(head.size() - 1)));
  }
  return bright;
}

/// Value of the skull: the darkest values in the head around the brain. BET's robust minimum of the whole
/// scan is the value of air; at low contrast the gap between brain and scalp is brighter than air.
float darkest(const Volume& working, const Mask& head, const BetSphere& sphere) {
  const Mask filled = fillHoles(close(head, kSkull_mm));
  std::vector<float> values;
  std::size_t at = 0;
  for (int k = 0; k < working.grid.size[2]; ++k)
    for (int j = 0; j < working.grid.size[1]; ++j)
      for (int i = 0; i < working.grid.size[0]; ++i, ++at)
        if (filled.voxels[at] &&
            (working.grid.toMri({double(i), double(j), double(k)}).mm - sphere.centre_mm).norm() <
                kSkullShare * sphere.radius_mm)
          values.push_back(working.voxels[at]);
  if (values.empty()) return 0;
  return std::max(0.f, selectRank(values, std::size_t(kDarkest * double(values.size()))));
}

/// Intensities of brain and skull, once the ball is known.
BetIntensities intensitiesIn(const Volume& working, const Mask& head, const BetSphere& sphere, float t98) {
  const BetIntensities found = betIntensities(working, sphere, darkest(working, head, sphere), t98);
  if (!(found.median > 0)) noBrain("there is nothing where the brain should be");
  return found;
}

}  // namespace

Volume workingVolume(const Volume& volume, double spacing_mm) {
  const float floor = volume::percentile(volume, 0.02);
  VoxelGrid grid = volume::isotropicGrid(volume.grid, spacing_mm);
  const int pad = int(std::ceil(kPad_mm / spacing_mm));
  for (int a = 0; a < 3; ++a) grid.size[a] += 2 * pad;
  grid.mri_from_voxel.translate(Eigen::Vector3d::Constant(-pad));
  // A coarse scan is interpolated by a cubic, which keeps its edges: trilinear interpolation would close thin
  // bone between brain and muscle. A fine one is averaged over neighbours against noise.
  const bool is_fine = volume.grid.spacing_mm().minCoeff() < kFine * spacing_mm;
  if (is_fine) return volume::resampleAbove(volume, floor, grid);
  Volume above{volume.grid, volume.voxels, volume.modality, volume.orientation_source};
  for (float& value : above.voxels) value = std::isfinite(value) ? value - floor : 0.f;
  return volume::resampleCubic(above, grid);
}

Volume halved(const Volume& volume, int first) {
  Volume out;
  out.modality = volume.modality;
  out.orientation_source = volume.orientation_source;
  out.grid = volume.grid;
  for (int a = 0; a < 3; ++a) out.grid.size[a] = std::max(1, (volume.grid.size[a] - first) / 2);
  out.grid.mri_from_voxel.translate(Eigen::Vector3d::Constant(first + 0.5));
  out.grid.mri_from_voxel.linear() *= 2;
  out.voxels.resize(out.grid.count());
  const std::size_t row = volume.grid.size[0], slab = row * volume.grid.size[1];
  std::size_t o = 0;
  for (int k = 0; k < out.grid.size[2]; ++k)
    for (int j = 0; j < out.grid.size[1]; ++j)
      for (int i = 0; i < out.grid.size[0]; ++i, ++o) {
        const float* p = &volume.voxels[volume.grid.index(2 * i + first, 2 * j + first, 2 * k + first)];
        out.voxels[o] =
            (p[0] + p[1] + p[row] + p[row + 1] + p[slab] + p[slab + 1] + p[slab + row] + p[slab + row + 1]) /
            8;
      }
  return out;
}

BrainStart centredOnBrain(const Volume& working, const BrainStart& start, double fractional_threshold,
                          TaskMonitor& monitor) {
  BetOptions rough;
  rough.fractional_threshold = fractional_threshold;
  rough.iterations = kRoughIterations;
  rough.subdivisions = kRoughSubdivisions;
  const Mask brain =
      enclosed(evolveBet(working, start.sphere, start.intensities, rough, monitor), working.grid);
  // A place where a ball of this size fits is brain; leaks into the neck or an orbit are too narrow.
  const Mask core = largestPart(erode(brain, kBallInBrain_mm));
  if (core.volume_ml() == 0) return start;
  BrainStart out;
  const double radius_mm = std::cbrt(dilate(core, kBallInBrain_mm).volume_ml() * 1e3 * 3 / (4 * M_PI));
  out.sphere = {ballLike(core).centre_mm, radius_mm};
  const float t98 = start.intensities.t98;
  out.intensities = intensitiesIn(working, headOf(working, kHeadShare * t98), out.sphere, t98);
  return out;
}

BrainStart findBrainStart(const Volume& working) {
  const float t98 = robustMaximum(working);
  if (!(t98 > 0)) noBrain("the volume has no contrast");
  const Mask head = headOf(working, kHeadShare * t98);
  const Slices slices = sliceAreas(head);
  const double spacing_mm = working.grid.spacing_mm().mean();
  int top = int(slices.area_mm2.size()) - 1;
  while (top >= 0 && slices.area_mm2[top] < kTopArea_mm2) --top;
  if (top < 0) noBrain("there is no head in this volume");
  const int from = std::max(0, top - int(kGirthFrom_mm / spacing_mm)),
            to = std::max(0, top - int(kGirthTo_mm / spacing_mm));
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double weight = 0;
  std::vector<double> areas;
  for (int k = from; k <= to; ++k) {
    areas.push_back(slices.area_mm2[k]);
    centre.head<2>() += slices.area_mm2[k] * slices.centre[k];
    weight += slices.area_mm2[k];
  }
  if (weight <= 0) noBrain("there is no head in this volume");
  const double girth_mm = std::sqrt(valueAtRank(areas, areas.size() * 3 / 4) / M_PI);
  if (!anatomy::kGirthRadius.contains(girth_mm))
    noBrain("the largest object is " + std::to_string(int(2 * girth_mm)) + " mm across, which is no head");
  // The first slice's area gives its height above the centre of a ball of that girth, also where the scan
  // cuts the top.
  const double below_top_mm =
      kRoundness * std::sqrt(std::max(0.0, girth_mm * girth_mm - slices.area_mm2[top] / M_PI));
  centre /= weight;
  centre.z() = top - below_top_mm / spacing_mm;
  BrainStart start;
  start.sphere = {working.grid.toMri(centre).mm, kBrainShare * girth_mm};
  start.intensities = intensitiesIn(working, head, start.sphere, t98);
  return start;
}

}  // namespace facenav::segmentation
