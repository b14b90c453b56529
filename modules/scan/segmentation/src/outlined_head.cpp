#include "outlined_head.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "facenav/anatomy/head_norms.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/segmentation/head_outline.h"
#include "facenav/volume/local_mean.h"
#include "facenav/volume/mask_morphology.h"
#include "head_morphology.h"
#include "head_pads.h"
#include "prior/brain_prior.h"

namespace facenav::segmentation {
namespace {

using volume::Mask;
using volume::Volume;

constexpr double kThinAttachment_mm =
    5.0;  // head holder shells, ghosts: removed by opening with a ball of this radius
constexpr double kSkinBlur_mm = 2;     // further from the head, none of its own signal is left
constexpr double kAround_mm = 4;       // radius of a place's surroundings
constexpr double kPadContact_mm = 10;  // this near to a pad, the pad's level counts as air's
constexpr double kLeastTissue = 0.5;   // share of the scan's tissue that shading leaves in a head
constexpr double kThinPad_mm = 2;      // half the thickness of a thing worth naming
constexpr double kHaze_mm = 6;         // haze is measured this near to the head
constexpr double kMuchHaze = 0.05;     // as a share of the skin's signal; scans without it show 0.02
constexpr int kRounds = 2;
constexpr float kSureAir = 0.7f;     // probability of air by the brain prior, whose voxels are coarse
constexpr float kLeastStep = 0.25f;  // of tissue above a pad, relative to above air: else both look alike
constexpr double kEarsAndNose_mm =
    14.0;  // parts removed by the opening are restored this far if tissue connects them

/// The coarse voxels above their limits, without those of `pads`.
Mask above(const BlockMeans& coarse, const std::vector<float>& limits, const Mask& pads) {
  Mask out{coarse.grid, std::vector<std::uint8_t>(coarse.mean.size())};
  for (std::size_t c = 0; c < coarse.mean.size(); ++c)
    out.voxels[c] = coarse.mean[c] > limits[c] && !pads.voxels[c];
  return out;
}

Mask coarseHead(const Mask& tissue, bool is_ct) {
  const Mask solid = withoutCavities(tissue);
  const Mask core = largestPart(open(solid, kThinAttachment_mm));
  const int steps = int(kEarsAndNose_mm / tissue.grid.spacing_mm().minCoeff());
  return fillCavities(growInside(core, is_ct ? open(solid, 1.5) : solid, steps));
}

/// Voxels of the head's outer layer, where its tissue is compared with air.
Mask outerTissue(const Mask& head, const std::optional<Volume>& air, double reach_mm) {
  const std::vector<float> depth_mm = depthWithin(head);
  Mask layer = head;
  for (std::size_t v = 0; v < layer.voxels.size(); ++v)
    layer.voxels[v] = head.voxels[v] && depth_mm[v] <= float(reach_mm) && !(air && air->voxels[v] > 0.5f);
  return layer;
}

/// Air, pads and haze: voxels beyond the skin's blur outside `head`, or air by the brain prior.
Mask surroundings(const Mask& head, const std::optional<Volume>& air, const Mask& pads) {
  Mask beyond = head;
  if (air)
    for (std::size_t v = 0; v < beyond.voxels.size(); ++v)
      beyond.voxels[v] = head.voxels[v] && air->voxels[v] < kSureAir;
  const std::vector<float> away_mm = distanceTo(beyond);
  Mask outside = pads;
  for (std::size_t v = 0; v < outside.voxels.size(); ++v)
    outside.voxels[v] = pads.voxels[v] || away_mm[v] > float(kSkinBlur_mm);
  return outside;
}

/// Mean, around each voxel, of the voxels set in `tissue` that are above their own local mean.
std::vector<float> localTissue(const Mask& tissue, const std::vector<float>& values, double reach_mm,
                               float otherwise) {
  const std::vector<float> mean = volume::localMean(tissue.grid, values, tissue.voxels, reach_mm, otherwise);
  std::vector<std::uint8_t> bright(values.size());
  for (std::size_t v = 0; v < values.size(); ++v) bright[v] = tissue.voxels[v] && values[v] > mean[v];
  return volume::localMean(tissue.grid, values, bright, reach_mm, otherwise);
}

/// Limits at `share` of the way from the head's surroundings to its tissue. Where both look alike, the limit
/// of the whole scan.
std::vector<float> localLimits(const BlockMeans& coarse, const HeadThreshold& threshold,
                               const std::vector<float>& tissue, const Mask& outside, const Mask& pads,
                               const HeadOutline& outline) {
  const float contrast = float(threshold.tissue - threshold.air);
  const float least_tissue = float(threshold.air + kLeastTissue * (threshold.tissue - threshold.air));
  const float noise = std::min(5 * float(threshold.air_sigma), 0.35f * contrast);
  const std::vector<float> around =
      volume::localMean(coarse.grid, coarse.mean, outside.voxels, kAround_mm, float(threshold.air));
  const std::vector<float> pad_mm = distanceTo(pads);
  std::vector<float> limits(coarse.mean.size());
  for (std::size_t v = 0; v < limits.size(); ++v) {
    const bool is_by_pad = pad_mm[v] < float(kPadContact_mm);
    const float here = std::max(tissue[v], least_tissue), step = here - around[v];
    limits[v] = around[v] + std::max(float(outline.local_share) * step, noise);
    if (is_by_pad && step < kLeastStep * (here - float(threshold.air)))
      limits[v] = float(threshold.air) + float(outline.local_share) * (here - float(threshold.air));
  }
  return limits;
}

/// Volume of the thick parts of `first` that are not in `head`; with the brain prior, only of parts that it
/// does not classify as tissue.
double leftOut_ml(const Mask& first, const Mask& head, const std::optional<Volume>& air, double least_ml) {
  const std::vector<float> away_mm = distanceTo(head);
  Mask beside = first;
  for (std::size_t v = 0; v < beside.voxels.size(); ++v)
    beside.voxels[v] =
        first.voxels[v] && away_mm[v] > float(kSkinBlur_mm) && !(air && air->voxels[v] < kSureAir);
  const double voxel_ml = beside.grid.voxelVolume_mm3() * 1e-3;
  beside = open(beside, kThinPad_mm);
  return volume::withoutSpecks(beside, std::size_t(least_ml / voxel_ml) + 1).volume_ml();
}

/// Median signal outside the head within some millimetres, as a share of the tissue's there.
double hazeAround(const BlockMeans& coarse, const HeadThreshold& threshold, const Mask& head,
                  const std::vector<float>& tissue, const Mask& pads) {
  const std::vector<float> away_mm = distanceTo(head), pad_mm = distanceTo(pads);
  std::vector<float> shares;
  for (std::size_t v = 0; v < away_mm.size(); ++v)
    if (away_mm[v] > float(kSkinBlur_mm) && away_mm[v] < float(kHaze_mm) && pad_mm[v] > float(kPadContact_mm))
      shares.push_back((coarse.mean[v] - float(threshold.air)) /
                       std::max(1e-6f, tissue[v] - float(threshold.air)));
  return shares.empty() ? 0 : upperMedian(std::move(shares));
}

/// Throws Error if the mask is noise or a phantom bottle, not a head. Size limits are generous: from a
/// child's head to a scan with shoulders.
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

}  // namespace

OutlinedHead outlinedHead(const Volume& scan, const BlockMeans& coarse, const HeadThreshold& threshold) {
  OutlinedHead out;
  out.pads = {coarse.grid, std::vector<std::uint8_t>(coarse.mean.size())};
  out.limits.assign(coarse.mean.size(), float(threshold.value));
  out.mask = coarseHead(above(coarse, out.limits, out.pads), threshold.is_ct);
  requireHead(out.mask);
  if (threshold.is_ct) return out;
  const HeadOutline& outline = settingsOf<HeadOutline>();
  const Mask first = out.mask;
  const std::optional<Volume> air = airByPrior(scan, coarse.grid);
  out.knows_pads = air.has_value();
  if (air) out.pads = findPads(first, *air, outline);
  const Mask layer = outerTissue(first, air, outline.tissue_reach_mm);
  const std::vector<float> tissue =
      localTissue(layer, coarse.mean, outline.tissue_reach_mm, float(threshold.tissue));
  Mask head = first;
  for (std::size_t v = 0; v < head.voxels.size(); ++v) head.voxels[v] = head.voxels[v] && !out.pads.voxels[v];
  for (int round = 0; round < kRounds; ++round) {  // the second treats haze in the first mask as air
    out.limits = localLimits(coarse, threshold, tissue, surroundings(head, air, out.pads), out.pads, outline);
    head = coarseHead(above(coarse, out.limits, out.pads), false);
  }
  out.mask = head;
  requireHead(out.mask);
  out.beside_ml = leftOut_ml(first, head, air, outline.pad_least_ml);
  out.haze = hazeAround(coarse, threshold, head, tissue, out.pads);
  return out;
}

std::vector<std::string> leftOutInWords(const OutlinedHead& head) {
  std::vector<std::string> words;
  if (!head.knows_pads)
    words.push_back(std::string("pads and earphones could not be told from skin, because the learned brain "
                                "prior ") +
                    (installedPrior().network ? "found no brain" : "is missing or damaged") +
                    ": compare the skin with the slices");
  if (head.beside_ml > 0)
    words.push_back(formatted(
        "pads, earphones or haze that touch the head (%.0f ml) were left out; the skin beneath them "
        "is less sure",
        head.beside_ml));
  if (head.haze > kMuchHaze)
    words.push_back(
        formatted("a faint haze surrounds the head (%.0f %% of the skin's signal); it was not "
                  "taken for skin",
                  100 * head.haze));
  return words;
}

}  // namespace facenav::segmentation
