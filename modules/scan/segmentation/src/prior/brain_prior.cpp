#include "prior/brain_prior.h"

#include <algorithm>
#include <cmath>

#include "brain_start.h"
#include "facenav/volume/mask_morphology.h"
#include "facenav/volume/regrid.h"
#include "prior/head_window.h"
#include "scan_grid.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr int kMostOffCentre = 15;  // voxels of 4 mm, either way: as in training (FAR_SHIFT_MM)
constexpr int kMoves = 3;
constexpr double kSettled_mm = 6;
constexpr double kLeastBrain_ml = 250;
constexpr double kBorder_mm = 16;
constexpr double kLeastShape = 0.1;  // share of the variance left in voxels of 4 mm; noise alone leaves 0.02

/// Middles of windows along one axis, voxels.
std::vector<double> middlesAlong(int size, int window) {
  const int beyond = size - window - 2 * kMostOffCentre;
  const int steps = beyond <= 0 ? 0 : (beyond + 2 * kMostOffCentre - 1) / (2 * kMostOffCentre);
  std::vector<double> middles;
  if (steps == 0) return {(size - 1) / 2.0};
  const double first = window / 2.0 + kMostOffCentre / 2.0, last = size - 1 - first;
  for (int s = 0; s <= steps; ++s) middles.push_back(first + (last - first) * s / steps);
  return middles;
}

double brain_ml(const Volume& brain) {
  double sum = 0;
  for (const float p : brain.voxels) sum += p >= 0.5f;
  return sum * brain.grid.voxelVolume_mm3() * 1e-3;
}

Volume brainIn(const PriorNetwork& network, const Volume& window) {
  return {window.grid, network.shares(window)[kPriorBrain], {}, {}};
}

Mask maskOf(const Volume& probability) {
  Mask mask{probability.grid, std::vector<std::uint8_t>(probability.voxels.size())};
  for (std::size_t v = 0; v < mask.voxels.size(); ++v) mask.voxels[v] = probability.voxels[v] >= 0.5f;
  return volume::largestPart(mask);
}

/// Variance of the voxels further than `margin_mm` from the grid's border, so that air padded to a scan does
/// not count.
double varianceWithin(const Volume& volume, double margin_mm) {
  const int margin = int(std::lround(margin_mm / volume.grid.spacing_mm().mean()));
  const auto& n = volume.grid.size;
  double count = 0, sum = 0, squares = 0;
  for (int k = margin; k < n[2] - margin; ++k)
    for (int j = margin; j < n[1] - margin; ++j)
      for (int i = margin; i < n[0] - margin; ++i) {
        const double v = volume.at(i, j, k);
        ++count, sum += v, squares += v * v;
      }
  return count > 0 ? squares / count - sum / count * sum / count : 0;
}

/// The middle of the brain; nullopt if there is none.
std::optional<Point<Mri>> placeOf(const PriorNetwork& network, const Volume& coarse) {
  Volume best;
  double most_ml = 0;
  for (const double z : middlesAlong(coarse.grid.size[2], kPriorSize[2]))
    for (const double y : middlesAlong(coarse.grid.size[1], kPriorSize[1]))
      for (const double x : middlesAlong(coarse.grid.size[0], kPriorSize[0])) {
        Volume brain = brainIn(network, headWindow(coarse, coarse.grid.toMri({x, y, z})));
        const double ml = brain_ml(brain);
        if (ml > most_ml) most_ml = ml, best = std::move(brain);
      }
  for (int move = 0; most_ml > 0; ++move) {
    const Point<Mri> centre(ballLike(maskOf(best)).centre_mm);
    if ((centre.mm - best.grid.centre().mm).norm() < kSettled_mm || move == kMoves)
      return most_ml < kLeastBrain_ml ? std::nullopt : std::optional(centre);
    best = brainIn(network, headWindow(coarse, centre));
    most_ml = brain_ml(best);
  }
  return std::nullopt;
}

/// Exchanges left and right; the grid stays.
std::vector<float> mirrored(const std::vector<float>& voxels, int row) {
  std::vector<float> out(voxels);
  for (auto from = out.begin(); from != out.end(); from += row) std::reverse(from, from + row);
  return out;
}

/// Adds the window's shares, and those of its mirror image, to sums on a finer grid.
void addShares(const PriorNetwork& network, const Volume& window, BrainPrior& sum) {
  const int row = window.grid.size[0];
  const PriorShares plain = network.shares(window);
  const PriorShares other = network.shares({window.grid, mirrored(window.voxels, row), {}, {}});
  for (const auto& [which, to] : {std::pair(kPriorBrain, &sum.brain), std::pair(kPriorFluid, &sum.fluid),
                                  std::pair(kPriorAir, &sum.air)}) {
    Volume mean{window.grid, mirrored(other[which], row), {}, {}};
    for (std::size_t v = 0; v < mean.voxels.size(); ++v)
      mean.voxels[v] = 0.5f * (mean.voxels[v] + plain[which][v]);
    const Volume fine = volume::resample(mean, to->grid);
    for (std::size_t v = 0; v < fine.voxels.size(); ++v) to->voxels[v] += 0.5f * fine.voxels[v];
  }
}

}  // namespace

volume::Mask BrainPrior::mask() const { return volume::fillHoles(maskOf(brain)); }

std::optional<BrainPrior> findBrainPrior(const PriorNetwork& network, const Volume& working) {
  const Volume half = halved(working), coarse = halved(half);
  // The network was never trained on a scan without a head, and sees a brain in plain noise.
  if (!(varianceWithin(coarse, kBorder_mm) > kLeastShape * varianceWithin(working, kBorder_mm)))
    return std::nullopt;
  const auto centre = placeOf(network, coarse);
  if (!centre) return std::nullopt;
  // Two windows, half a voxel apart, so that the outline does not depend on where the voxels of 4 mm lie.
  const Volume first = headWindow(coarse, *centre), second = headWindow(halved(half, 1), *centre);
  BrainPrior prior;
  prior.brain.grid = first.grid;
  for (int& size : prior.brain.grid.size) size *= 2;
  prior.brain.grid.mri_from_voxel.linear() /= 2;
  prior.brain.voxels.assign(prior.brain.grid.count(), 0);
  prior.air = prior.fluid = prior.brain;
  addShares(network, first, prior);
  addShares(network, second, prior);
  return prior;
}

}  // namespace facenav::segmentation
