// Head mask. Air and tissue are separated on block means of about 2 mm, where noise and ghosts are weak, by a
// limit between the air and the tissue of each place (shading, haze). Cavities are closed; pads are removed
// (head_pads.h), and thin attachments (head holders, ghosts, wrap-around) by an opening. Voxels near that
// coarse outline are then decided at full resolution.

#include <algorithm>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/segmentation/segmenter.h"
#include "facenav/volume/for_slices.h"
#include "facenav/volume/mask_morphology.h"
#include "head_morphology.h"
#include "head_threshold.h"
#include "outlined_head.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

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

/// Gives each voxel of the shell the majority value of its 27-neighbourhood, for a smooth outline.
Mask majority(const Mask& fine, const Mask& outer, const Mask& inner, const BlockMeans& coarse) {
  Mask out = fine;
  const std::size_t nx = fine.grid.size[0], nxy = nx * fine.grid.size[1];
  volume::forSlices(fine.grid.size[2] - 2, [&](int before) {
    const int k = before + 1;
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
  });
  return out;
}

Mask refined(const Volume& volume, const BlockMeans& coarse, const OutlinedHead& outlined) {
  const Mask& head = outlined.mask;
  const double shell_mm = 1.01 * coarse.grid.spacing_mm().maxCoeff();
  const Mask inner = erode(head, shell_mm), outer = dilate(head, shell_mm);
  Mask fine{volume.grid, std::vector<std::uint8_t>(volume.voxels.size())};
  volume::forSlices(volume.grid.size[2], [&](int k) {
    std::size_t v = volume.grid.index(0, 0, k);
    for (int j = 0; j < volume.grid.size[1]; ++j)
      for (int i = 0; i < volume.grid.size[0]; ++i, ++v) {
        const std::size_t c = head.grid.index(i / coarse.block[0], j / coarse.block[1], k / coarse.block[2]);
        if (inner.voxels[c])
          fine.voxels[v] = 1;
        else if (outer.voxels[c] && !outlined.pads.voxels[c])
          fine.voxels[v] = crossMean(volume, i, j, k) > outlined.limits[c];
      }
  });
  fine = majority(fine, outer, inner, coarse);  // each step's mask is freed before the next one
  fine = largestPart(fine);
  return fillCavities(fine);
}

class HeadSegmenter : public Segmenter {
 public:
  SegmentationResult segment(const Volume& volume, TaskMonitor& monitor) const override {
    monitor.report("head mask", 0.0);
    if (volume.grid.count() == 0 || volume.voxels.size() != volume.grid.count())
      throw Error("no head in this volume: it is empty", {}, "choose another series");
    const BlockMeans coarse = blockMeans(volume);
    const HeadThreshold threshold = findHeadThreshold(coarse.mean, volume.modality);
    const OutlinedHead head = outlinedHead(volume, coarse, threshold);
    monitor.report("head mask", 0.5);
    SegmentationResult result{refined(volume, coarse, head), {}};
    if (threshold.air_sigma > 0.12 * (threshold.tissue - threshold.air))
      result.warnings.push_back("the air around the head is noisy: the skin may be placed less accurately");
    for (const auto& words : leftOutInWords(head)) result.warnings.push_back(words);
    monitor.report("head mask", 1.0);
    return result;
  }
};

}  // namespace

std::unique_ptr<Segmenter> makeHeadSegmenter() { return std::make_unique<HeadSegmenter>(); }

}  // namespace facenav::segmentation
