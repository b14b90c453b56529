// Head mask. Air and tissue are separated on block means of about 2 mm, where noise and ghosts are weak.
// Cavities are closed, and thin attachments (head holders, ghosts, wrap-around) are removed by an opening.
// Voxels near that coarse outline are then decided at full resolution.

#include <algorithm>
#include <cmath>

#include "facenav/anatomy/head_norms.h"
#include "facenav/core/error.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/volume/mask_morphology.h"
#include "head_morphology.h"
#include "head_threshold.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;
using volume::VoxelGrid;

constexpr double kCoarse_mm = 2.0;
constexpr double kNarrowOpening_mm = 4.0;  // ear canals, nostrils: closed with a ball of this radius
constexpr double kThinAttachment_mm =
    5.0;  // head holder shells, ghosts: removed by opening with a ball of this radius
constexpr int kMostOpenDirections =
    4;  // of 26: a voxel that sees the outside in at most this many lies in a cavity
constexpr double kEarsAndNose_mm =
    14.0;  // parts removed by the opening are restored this far if tissue connects them

struct Coarse {
  std::array<int, 3> block;
  std::array<int, 3> size;
  Eigen::Vector3d spacing_mm;
  std::vector<float> mean;
};

Coarse blockMeans(const Volume& volume) {
  Coarse out;
  const Eigen::Vector3d spacing = volume.grid.spacing_mm();
  for (int a = 0; a < 3; ++a) {
    out.block[a] = std::max(1, int(std::lround(kCoarse_mm / spacing[a])));
    out.size[a] = (volume.grid.size[a] + out.block[a] - 1) / out.block[a];
    out.spacing_mm[a] = spacing[a] * out.block[a];
  }
  out.mean.assign(std::size_t(out.size[0]) * out.size[1] * out.size[2], 0.f);
  std::vector<int> count(out.mean.size());
  std::size_t v = 0;
  for (int k = 0; k < volume.grid.size[2]; ++k)
    for (int j = 0; j < volume.grid.size[1]; ++j) {
      const std::size_t row =
          std::size_t(out.size[0]) * (j / out.block[1] + std::size_t(out.size[1]) * (k / out.block[2]));
      for (int i = 0; i < volume.grid.size[0]; ++i, ++v)
        if (std::isfinite(volume.voxels[v]))
          out.mean[row + i / out.block[0]] += volume.voxels[v], ++count[row + i / out.block[0]];
    }
  for (std::size_t c = 0; c < out.mean.size(); ++c)
    out.mean[c] = count[c] ? out.mean[c] / float(count[c]) : 0.f;
  return out;
}

Mask above(const Coarse& coarse, double threshold) {
  Mask out;
  out.grid.size = coarse.size;
  out.grid.mri_from_voxel.linear() = coarse.spacing_mm.asDiagonal();
  out.voxels.resize(coarse.mean.size());
  for (std::size_t c = 0; c < coarse.mean.size(); ++c) out.voxels[c] = coarse.mean[c] > threshold;
  return out;
}

/// Tissue plus the cavities within it. Filled creases of the outer surface (between ear and head, beside the
/// nose) are removed again.
Mask withoutCavities(const Mask& tissue) {
  const Mask closed = close(fillOccluded(tissue, kMostOpenDirections), kNarrowOpening_mm);
  const Mask filled = fillCavities(closed);
  Mask cavities = filled;
  for (std::size_t v = 0; v < cavities.voxels.size(); ++v)
    cavities.voxels[v] = filled.voxels[v] && !closed.voxels[v];
  Mask plugs = dilate(cavities, kNarrowOpening_mm + tissue.grid.spacing_mm().maxCoeff());
  for (std::size_t v = 0; v < plugs.voxels.size(); ++v) plugs.voxels[v] = plugs.voxels[v] && filled.voxels[v];
  return fillCavities(fillOccluded(unionOf(plugs, tissue), kMostOpenDirections));
}

Mask coarseHead(const Coarse& coarse, const HeadThreshold& threshold) {
  const Mask tissue = above(coarse, threshold.value);
  const Mask solid = withoutCavities(tissue);
  const Mask core = largestPart(open(solid, kThinAttachment_mm));
  const int steps = int(kEarsAndNose_mm / coarse.spacing_mm.minCoeff());
  return fillCavities(growInside(core, threshold.is_ct ? open(solid, 1.5) : solid, steps));
}

/// Is this a head, and not noise or a phantom bottle? Size limits are generous: from a child's head to a scan
/// with shoulders.
void requireHead(const Mask& head) {
  std::array<int, 3> low = head.grid.size, high{-1, -1, -1};
  std::size_t count = 0, v = 0;
  for (int k = 0; k < head.grid.size[2]; ++k)
    for (int j = 0; j < head.grid.size[1]; ++j)
      for (int i = 0; i < head.grid.size[0]; ++i, ++v)
        if (head.voxels[v]) {
          ++count;
          const std::array<int, 3> at{i, j, k};
          for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], at[a]), high[a] = std::max(high[a], at[a]);
        }
  const double volume_ml = double(count) * head.grid.spacing_mm().prod() / 1000.0;
  std::array<double, 3> extent_mm;
  for (int a = 0; a < 3; ++a) extent_mm[a] = (high[a] - low[a] + 1) * head.grid.spacing_mm()[a];
  std::sort(extent_mm.begin(), extent_mm.end());
  const char* remedy = "choose a T1 or CT series that shows the whole head";
  if (count == 0 || !anatomy::kScannedHead.contains(volume_ml) ||
      !anatomy::kScannedHeadMiddle.contains(extent_mm[1]) ||
      !anatomy::kScannedHeadShortest.contains(extent_mm[0]))
    throw Error("no head in this volume: nothing of a head's size stands out from the background", {},
                remedy);
  if (count > 0.985 * double(head.voxels.size()))
    throw Error("no head in this volume: there is no air around it", {}, remedy);
}

/// Mean of the voxel and its 6 neighbours, so that noise at full resolution does not roughen the outline.
float crossMean(const Volume& volume, int i, int j, int k) {
  const auto& size = volume.grid.size;
  double sum = volume.at(i, j, k);
  int n = 1;
  const auto add = [&](int a, int b, int c) {
    if (volume.grid.contains(a, b, c)) sum += volume.at(a, b, c), ++n;
  };
  if (size[0] > 0)
    add(i - 1, j, k), add(i + 1, j, k), add(i, j - 1, k), add(i, j + 1, k), add(i, j, k - 1),
        add(i, j, k + 1);
  return float(sum / n);
}

/// Each voxel of the shell takes the majority value of its 27-neighbourhood, for a smooth outline.
Mask majority(const Mask& fine, const Mask& outer, const Mask& inner, const Coarse& coarse) {
  Mask out = fine;
  const std::size_t nx = fine.grid.size[0], nxy = nx * fine.grid.size[1];
  for (int k = 1; k + 1 < fine.grid.size[2]; ++k)
    for (int j = 1; j + 1 < fine.grid.size[1]; ++j)
      for (int i = 1; i + 1 < fine.grid.size[0]; ++i) {
        const std::size_t c = outer.grid.index(i / coarse.block[0], j / coarse.block[1], k / coarse.block[2]);
        if (!outer.voxels[c] || inner.voxels[c]) continue;
        const std::size_t v = fine.grid.index(i, j, k);
        int set = 0;
        for (const std::size_t slice : {v - nxy, v, v + nxy})
          for (const std::size_t row : {slice - nx, slice, slice + nx})
            set += fine.voxels[row - 1] + fine.voxels[row] + fine.voxels[row + 1];
        out.voxels[v] = set >= 14;
      }
  return out;
}

Mask refined(const Volume& volume, const Coarse& coarse, const Mask& head, double threshold) {
  const double shell_mm = 1.01 * coarse.spacing_mm.maxCoeff();
  const Mask inner = erode(head, shell_mm), outer = dilate(head, shell_mm);
  Mask fine{volume.grid, std::vector<std::uint8_t>(volume.voxels.size())};
  std::size_t v = 0;
  for (int k = 0; k < volume.grid.size[2]; ++k)
    for (int j = 0; j < volume.grid.size[1]; ++j)
      for (int i = 0; i < volume.grid.size[0]; ++i, ++v) {
        const std::size_t c = head.grid.index(i / coarse.block[0], j / coarse.block[1], k / coarse.block[2]);
        if (inner.voxels[c])
          fine.voxels[v] = 1;
        else if (outer.voxels[c])
          fine.voxels[v] = crossMean(volume, i, j, k) > threshold;
      }
  return fillCavities(largestPart(majority(fine, outer, inner, coarse)));
}

class HeadSegmenter : public Segmenter {
 public:
  SegmentationResult segment(const Volume& volume, TaskMonitor& monitor) const override {
    monitor.report("head mask", 0.0);
    if (volume.grid.count() == 0 || volume.voxels.size() != volume.grid.count())
      throw Error("no head in this volume: it is empty", {}, "choose another series");
    const Coarse coarse = blockMeans(volume);
    const HeadThreshold threshold = findHeadThreshold(coarse.mean, volume.modality);
    const Mask head = coarseHead(coarse, threshold);
    requireHead(head);
    monitor.report("head mask", 0.5);
    SegmentationResult result{refined(volume, coarse, head, threshold.value), {}};
    if (threshold.air_sigma > 0.12 * (threshold.tissue - threshold.air))
      result.warnings.push_back("the air around the head is noisy: the skin may be placed less accurately");
    monitor.report("head mask", 1.0);
    return result;
  }
};

}  // namespace

std::unique_ptr<Segmenter> makeHeadSegmenter() { return std::make_unique<HeadSegmenter>(); }

}  // namespace facenav::segmentation
